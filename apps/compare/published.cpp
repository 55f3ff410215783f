#include "apps/compare/published.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lineservo::apps {
namespace {

// topology Tab. 2 to 4. Its Tab. 3 gives the deviations in x and in y, each over the whole flight with zeros
// from the other leg: together they are √(RMSE_x² + RMSE_y²), max(ME_x, ME_y) and MAE_x + MAE_y.
struct Topology {
  std::string_view title;
  double accuracy, rmse_y_m, rmse_x_m, max_y_m, max_x_m, mae_y_m, mae_x_m, terminal_m, duration_s;
};
constexpr std::array<Topology, 4> kTopology = {{
    {"a03", 0.9440, 0.0, 0.09, 0.0, 0.23, 0.0, 0.07, 0.16, 76.87},
    {"a13", 0.9273, 0.01, 0.03, 0.05, 0.16, 0.003, 0.01, 0.16, 117.25},
    {"a23", 0.9034, 0.03, 0.06, 0.19, 0.35, 0.008, 0.03, 0.14, 153.48},
    {"a53", 0.9055, 0.04, 0.04, 0.18, 0.26, 0.020, 0.02, 0.19, 312.69},
}};

PublishedRow row(const Topology& t) {
  PublishedRow row{t.title, "pid", "topology Tab. 2-4", {}, {}, {}, {}, {}, {}, "one flight"};
  row.junction_accuracy = t.accuracy;
  row.rmse_m = std::hypot(t.rmse_x_m, t.rmse_y_m);
  row.max_m = std::max(t.max_x_m, t.max_y_m);
  row.mean_m = t.mae_x_m + t.mae_y_m;
  row.terminal_error_m = t.terminal_m;
  row.duration_s = t.duration_s;
  return row;
}

PublishedRow straight(std::string_view who, std::string_view source, double mean_m, double max_m,
                      std::string_view note) {
  return {"straight", who, source, {}, {}, max_m, mean_m, {}, {}, note};
}

std::vector<PublishedRow> all() {
  std::vector<PublishedRow> rows;
  for (const Topology& t : kTopology) rows.push_back(row(t));
  rows.push_back(straight("lfpf", "lfpf §4.1.1", 0.0617, 0.30, "pitch -0.19 deg: about 0.09 m/s here"));
  rows.push_back(
      straight("improved-carrot", "lfpf §4.1.1", 0.1859, 0.60, "pitch -1 deg: about 0.46 m/s here"));
  rows.push_back(straight("lfpf", "lfpf §4.2.1", 0.1330, 0.40, "10 real flights"));
  rows.push_back({"minidrone", "vtp", "vtp §3", {}, {}, {}, {}, {}, {}, "its paper prints no figures"});
  return rows;
}

nlohmann::ordered_json number(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

nlohmann::ordered_json to_json(const PublishedRow& row) {
  return {{"title", row.title},
          {"who", row.who},
          {"source", row.source},
          {"junction_accuracy", number(row.junction_accuracy)},
          {"rmse_m", number(row.rmse_m)},
          {"max_m", number(row.max_m)},
          {"mean_m", number(row.mean_m)},
          {"terminal_error_m", number(row.terminal_error_m)},
          {"duration_s", number(row.duration_s)},
          {"note", row.note}};
}

const std::vector<PublishedRange>& published_ranges() {
  static const std::vector<PublishedRange> kRanges = {
      {"junction_accuracy", 0.9034, 0.9440, "topology Tab. 2"},
      {"rmse_m", 0.019, 0.090, "topology, per leg, from its authors' logs"},
      {"max_m", 0.05, 0.35, "topology Tab. 3"},
      {"terminal_error_m", 0.14, 0.19, "topology Tab. 4"},
  };
  return kRanges;
}

std::vector<PublishedRow> published_beside(const std::string& title) {
  std::vector<PublishedRow> rows;
  for (const PublishedRow& row : all()) {
    if (row.title == title) rows.push_back(row);
  }
  return rows;
}

}  // namespace lineservo::apps
