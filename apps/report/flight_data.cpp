#include "apps/report/flight_data.h"

#include <limits>

#include "apps/compare/published.h"
#include "apps/output/command_row.h"
#include "apps/output/json_text.h"
#include "apps/report/floor_json.h"
#include "apps/report/json_columns.h"
#include "apps/report/tick_rows.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

constexpr int kTimeDecimals = 4, kDecimals = 6;  // as in flight.csv
constexpr int kMillimetres = 3;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ordered_json published_json(const FlightRequest& request) {
  ordered_json rows = ordered_json::array(), ranges = ordered_json::array();
  for (const std::string& title : {request.instruction, request.layout}) {
    for (const PublishedRow& row : published_beside(title)) rows.push_back(to_json(row));
  }
  for (const PublishedRange& r : published_ranges())
    ranges.push_back({{"metric", r.metric}, {"low", r.low}, {"high", r.high}, {"source", r.source}});
  return {{"rows", rows}, {"ranges", ranges}};
}

ordered_json events_json(const FlightRecord& record) {
  ordered_json events = ordered_json::array();
  for (const EventRecord& event : record.events)
    events.push_back({{"t_s", vehicle::seconds(event.t)}, {"kind", event.kind}, {"detail", event.detail}});
  return events;
}

ordered_json phases_json() {
  ordered_json names = ordered_json::array();
  for (int phase = 0; phase <= static_cast<int>(servo::Phase::search); ++phase)
    names.push_back(servo::name(static_cast<servo::Phase>(phase)));
  return names;
}

ordered_json thumbnails_json(const std::vector<Thumbnail>& thumbnails) {
  ordered_json list = ordered_json::array();
  for (const Thumbnail& thumbnail : thumbnails)
    list.push_back({{"t_s", thumbnail.t_s}, {"uri", thumbnail.data_uri}});
  return list;
}

/// "ticks": an object of columns with the names of flight.csv.
class TickColumns {
 public:
  TickColumns(std::string& json, const std::vector<TickRow>& rows) : json_(json), rows_(rows) {
    json_ += "{";
  }

  template <class Value>
  void add(std::string_view name, int decimals, Value value) {
    if (json_.back() != '{') json_ += ",";
    append_column(json_, name, rows_, decimals, value);
  }
  template <class Value>
  void add_of_tick(std::string_view name, Value value) {
    add(name, kDecimals, [&value](const TickRow& row) { return value(*row.tick); });
  }
  /// What a command's kind does not set is null.
  void add_commands() {
    for (std::size_t i = 0; i < kCommandColumns.size(); ++i)
      add("command_" + std::string(kCommandColumns[i]), kDecimals,
          [i](const TickRow& row) { return row_of(row.tick->command)[i]; });
  }
  void end() { json_ += "}"; }

 private:
  std::string& json_;
  const std::vector<TickRow>& rows_;
};

/// Where dead reckoning has the vehicle at a tick, in W: laid on its true pose at the first tick.
Eigen::Vector2d reckoned_W(const TickRecord& tick, const TickRecord& first) {
  const servo::Motion flown = servo::between(first.odometry, tick.odometry);
  return first.now.p_WB.head<2>() + Eigen::Rotation2Dd(first.now.heading_rad) * flown.translation_m;
}

void add_reckoned(TickColumns& columns, const FlightRecord& record) {
  for (const auto& [name, axis] : {std::pair{"reckoned_x_m", 0}, {"reckoned_y_m", 1}})
    columns.add(name, kMillimetres,
                [&](const TickRow& row) { return reckoned_W(*row.tick, record.ticks.front())[axis]; });
}

void add_truth(TickColumns& columns) {
  columns.add("t_s", kTimeDecimals, [](const TickRow& row) { return vehicle::seconds(row.tick->t); });
  columns.add("phase", 0, [](const TickRow& row) { return static_cast<double>(row.tick->now.phase); });
  columns.add("step", 0, [](const TickRow& row) { return row.tick->now.step; });
  columns.add_of_tick("x_m", [](const TickRecord& tick) { return tick.now.p_WB.x(); });
  columns.add_of_tick("y_m", [](const TickRecord& tick) { return tick.now.p_WB.y(); });
  columns.add_of_tick("z_m", [](const TickRecord& tick) { return tick.now.p_WB.z(); });
  columns.add_of_tick("roll_rad", [](const TickRecord& tick) { return tick.now.roll_rad; });
  columns.add_of_tick("pitch_rad", [](const TickRecord& tick) { return tick.now.pitch_rad; });
  columns.add_of_tick("heading_rad", [](const TickRecord& tick) { return tick.now.heading_rad; });
  columns.add("error_m", kDecimals, [](const TickRow& row) { return row.error_m; });
  columns.add("leg", 0, [](const TickRow& row) { return row.leg < 0 ? kNaN : row.leg; });
  columns.add("turning", 0, [](const TickRow& row) { return row.turning ? 1.0 : 0.0; });
}

void add_seen(TickColumns& columns) {
  columns.add_of_tick("height_estimate_m", [](const TickRecord& tick) { return tick.height_m; });
  columns.add_of_tick("forward_estimate_m_s", [](const TickRecord& tick) { return tick.v_H_m_s.x(); });
  columns.add_of_tick("left_estimate_m_s", [](const TickRecord& tick) { return tick.v_H_m_s.y(); });
  columns.add("code_true", 0, [](const TickRow& row) { return row.true_code < 0 ? kNaN : row.true_code; });
  columns.add("code_raw", 0, [](const TickRow& row) { return static_cast<double>(row.tick->code.raw); });
  columns.add("code_smoothed", 0,
              [](const TickRow& row) { return static_cast<double>(row.tick->code.smoothed); });
}

void append_member(std::string& json, std::string_view name, const ordered_json& value) {
  json.append(",\"").append(name).append("\":").append(json_text(value));
}

}  // namespace

std::string flight_data(const Mission& mission, const FlightRecord& record, const FlightSummary& summary,
                        const std::vector<Thumbnail>& thumbnails) {
  const RouteTruth route = route_truth(mission.floor, mission.plan);
  std::string json = R"({"kind":"flight")";
  append_member(json, "summary", to_json(mission.request, summary));
  append_member(json, "published", published_json(mission.request));
  append_member(json, "floor", floor_json(mission.floor));
  append_member(json, "route", route_json(route));
  append_member(json, "events", events_json(record));
  append_member(json, "phases", phases_json());
  append_member(json, "thumbnails", thumbnails_json(thumbnails));
  json += ",\"ticks\":";
  const std::vector<TickRow> rows = tick_rows(record, route, summary.junctions);
  TickColumns columns(json, rows);
  add_truth(columns);
  add_seen(columns);
  add_reckoned(columns, record);
  columns.add_commands();
  columns.end();
  return json + "}";
}

}  // namespace lineservo::apps
