#include "apps/report/comparison_data.h"

#include <cmath>

#include "apps/compare/metrics.h"
#include "apps/output/json_text.h"
#include "apps/report/json_columns.h"
#include "features/junction/code_filter.h"

namespace lineservo::apps {
namespace {

using features::JunctionCode;
using nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 600;  ///< of a path
constexpr int kWindows[] = {1, 3, 5, 9};  ///< topology Fig. 7

/// The bins of the signed error that are not empty: [index, samples, index, samples, …].
ordered_json signed_bins(const Contestant& contestant) {
  SignedDistribution sum{};
  for (const ComparedFlight& flight : contestant.flights) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += flight.summary.track.signed_distribution[i];
  }
  ordered_json bins = ordered_json::array();
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (sum[i] > 0) bins.insert(bins.end(), {i, sum[i]});
  }
  return bins;
}

/// 95 % bootstrap intervals of the means over the flights that have the figure; none for a single one.
ordered_json intervals(const Contestant& contestant) {
  ordered_json json = ordered_json::object();
  for (const Metric& metric : metrics()) {
    std::vector<double> values;
    for (const ComparedFlight& flight : contestant.flights) {
      const double value = metric.of(flight.summary);
      if (std::isfinite(value)) values.push_back(value);
    }
    const Interval ci95 = paired_difference(values).ci95;
    if (std::isfinite(ci95.low)) json[std::string(metric.name)] = {ci95.low, ci95.high};
  }
  return json;
}

/// [code, frames, code, frames, …]
template <class Codes, class CodeOf>
ordered_json run_lengths(const Codes& codes, CodeOf code_of) {
  std::vector<long> runs;
  for (const auto& entry : codes) {
    const long code = code_of(entry);
    if (runs.empty() || runs[runs.size() - 2] != code) runs.insert(runs.end(), {code, 0});
    ++runs.back();
  }
  return runs;
}

/// The codes that a window of so many frames makes of the same frames.
ordered_json smoothed_runs(const std::vector<TracedCode>& codes, int window) {
  features::CodeFilter filter(window);
  return run_lengths(
      codes, [&filter](const TracedCode& c) { return static_cast<long>(filter.update(c.raw).smoothed); });
}

ordered_json codes_json(const std::vector<TracedCode>& codes) {
  ordered_json json = {
      {"true", run_lengths(codes, [](const TracedCode& c) { return c.true_code; })},
      {"raw", run_lengths(codes, [](const TracedCode& c) { return static_cast<long>(c.raw); })}};
  json["windows"] = ordered_json::array();
  for (const int window : kWindows)
    json["windows"].push_back({{"frames", window}, {"runs", smoothed_runs(codes, window)}});
  return json;
}

std::string path_columns(const FlightTrace& trace) {
  const std::vector<TracePoint> points = thinned(trace.points, kMostPoints);
  std::string json = "{";
  append_column(json, "t_s", points, 2, [](const TracePoint& p) { return p.t_s; });
  append_column(json += ",", "x_m", points, 4, [](const TracePoint& p) { return p.x_m; });
  append_column(json += ",", "y_m", points, 4, [](const TracePoint& p) { return p.y_m; });
  append_column(json += ",", "error_m", points, 4, [](const TracePoint& p) { return p.error_m; });
  append_column(json += ",", "leg", points, 0, [](const TracePoint& p) { return p.leg; });
  return json + "}";
}

/// Each floor once, in the order of the rows.
ordered_json floors_json(const ComparisonResult& result) {
  ordered_json floors = ordered_json::object();
  for (const Contestant& c : result.contestants) {
    for (const ComparedFlight& flight : c.flights) {
      if (flight.trace && !floors.contains(c.entry.layout)) floors[c.entry.layout] = flight.trace->floor;
    }
  }
  return floors;
}

/// The members of an object without its brackets.
std::string members(const ordered_json& object) {
  std::string text = json_text(object);
  return text.substr(1, text.rfind('}') - 1);
}

void append_trace(std::string& json, std::size_t row, const ComparedFlight& flight) {
  const FlightTrace& trace = *flight.trace;
  json += "{" + members({{"row", row},
                         {"instruction", flight.instruction},
                         {"seed", flight.seed},
                         {"outcome", flight.summary.outcome},
                         {"target", {flight.summary.target_W.x(), flight.summary.target_W.y()}},
                         {"route", trace.route},
                         {"codes", codes_json(trace.codes)}});
  json += ",\"path\":" + path_columns(trace) + "}";
}

std::string traces_json(const ComparisonResult& result) {
  std::string json = "[";
  for (std::size_t row = 0; row < result.contestants.size(); ++row) {
    for (const ComparedFlight& flight : result.contestants[row].flights) {
      if (!flight.trace) continue;
      if (json.back() != '[') json += ",";
      append_trace(json, row, flight);
    }
  }
  return json + "]";
}

}  // namespace

std::string comparison_data(const ComparisonResult& result) {
  ordered_json errors = ordered_json::array(), means = ordered_json::array();
  for (const Contestant& c : result.contestants) {
    errors.push_back(signed_bins(c));
    means.push_back(intervals(c));
  }
  const ordered_json json = {
      {"kind", "comparison"},
      {"comparison", comparison_json(result)},
      {"errors", {{"bin_m", kSignedErrorBin_m}, {"bins", SignedDistribution{}.size()}, {"rows", errors}}},
      {"mean_ci95", means},
      {"floors", floors_json(result)}};
  return "{" + members(json) + ",\"traces\":" + traces_json(result) + "}";
}

}  // namespace lineservo::apps
