#include "apps/output/flight_summary.h"

#include <cmath>
#include <limits>

#include "apps/config/mission_file.h"
#include "apps/flight/convert.h"
#include "apps/output/flight_tables.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

double flown_m(const FlightRecord& record) {
  double sum = 0.0;
  for (std::size_t i = 1; i < record.truth.size(); ++i) {
    sum += (record.truth[i].p_WB - record.truth[i - 1].p_WB).head<2>().norm();
  }
  return sum;
}

ordered_json to_json(const OffsetStatistics& s) {
  return {{"rmse_m", number(s.rmse_m)},
          {"max_m", number(s.max_m)},
          {"mae_m", number(s.mae_m)},
          {"std_m", number(s.std_m)},
          {"mean_m", number(s.mean_m)}};
}

ordered_json to_json(const LegScore& leg) {
  ordered_json json = {{"from", leg.from},
                       {"to", leg.to},
                       {"axis", leg.axis.empty() ? ordered_json() : ordered_json(leg.axis)}};
  json.update(to_json(leg.whole));
  json["settled_rmse_m"] = number(leg.settled_rmse_m);
  json["turn_max_m"] = number(leg.turn_max_m);
  json["samples"] = leg.samples;
  return json;
}

ordered_json to_json(const JunctionScore& j) {
  ordered_json json = {{"frames", j.frames},
                       {"misclassified", j.misclassified},
                       {"accuracy", number(j.accuracy(j.misclassified))},
                       {"held_accuracy", number(j.accuracy(j.held_wrong))},
                       {"smoothed_accuracy", number(j.accuracy(j.smoothed_wrong))},
                       {"ambiguous_share", number(1.0 - j.accuracy(j.ambiguous))},
                       {"events", j.events},
                       {"events_right", j.events_right}};
  json["confusion"] = j.confusion;
  return json;
}

ordered_json to_json(const FlightTiming& t, double duration_s) {
  return {{"wall_s", t.wall_s},
          {"real_time_factor", number(duration_s / t.wall_s)},
          {"render_ms", t.render.mean_ms()},
          {"perception_ms", t.perception.mean_ms()},
          {"control_ms", t.control.mean_ms()},
          {"physics_ms", t.physics.calls == 0 ? 0.0 : 1000.0 * t.physics.total_s / (1000.0 * duration_s)}};
}

ordered_json arrival_json(const std::optional<Rest>& rest) {
  if (!rest) return {{"x_m", nullptr}, {"y_m", nullptr}, {"heading_rad", nullptr}};
  return {{"x_m", rest->x_m}, {"y_m", rest->y_m}, {"heading_rad", rest->heading_rad}};
}

ordered_json to_json(const TargetScore& t) {
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::Vector2d landing_W = t.landing_W.value_or(nowhere);
  return {{"target", t.target},
          {"node", t.node},
          {"x_m", t.node_W.x()},
          {"y_m", t.node_W.y()},
          {"outcome", t.outcome},
          {"arrival", arrival_json(t.rest)},
          {"arrived_s", t.rest ? ordered_json(t.rest->until_s) : ordered_json()},
          {"terminal_error_m", t.rest ? ordered_json(t.rest->target_error_m) : ordered_json()},
          {"terminal_max_m", t.rest ? ordered_json(t.rest->target_max_m) : ordered_json()},
          {"landing", {{"x_m", number(landing_W.x())}, {"y_m", number(landing_W.y())}}},
          {"landing_error_m", number((landing_W - t.node_W).norm())}};
}

}  // namespace

FlightSummary summarise(const FlightRequest& request, const vehicle::Layout& floor, const servo::Plan& plan,
                        const FlightRecord& record) {
  const RouteTruth route = route_truth(floor, plan);
  const features::CameraModel camera(camera_parameters(request.settings.camera));
  FlightSummary summary;
  summary.targets = score_targets(record, floor, plan);
  summary.target = summary.targets.back().node;
  summary.target_W = summary.targets.back().node_W;
  summary.rest = summary.targets.back().rest;
  summary.outcome = flight_outcome(record, summary.targets);
  summary.duration_s = record.truth.empty() ? 0.0 : vehicle::seconds(record.truth.back().t);
  summary.distance_m = flown_m(record);
  summary.tilt_rate_rms_rad_s = tilt_rate_rms_rad_s(record);
  summary.hold = score_hold(record, route.closing_steps.back(), summary.target_W);
  summary.track = score_track(record, route);
  summary.junctions =
      score_junctions(record, JunctionTruth(floor, camera), 1.0 / request.settings.camera.frame_rate_hz);
  summary.timing = record.timing;
  summary.trajectory_sha256 = trajectory_sha256(record);
  return summary;
}

ordered_json to_json(const FlightRequest& request, const FlightSummary& s) {
  ordered_json json = {{"instruction", request.instruction},
                       {"controller", request.controller},
                       {"layout", request.layout},
                       {"conditions", request.conditions},
                       {"seed", request.seed},
                       {"speed_m_s", request.settings.speed_m_s},
                       {"version", kVersion},
                       {"outcome", s.outcome}};
  json["target"] = {{"node", s.target}, {"x_m", s.target_W.x()}, {"y_m", s.target_W.y()}};
  json["arrival"] = arrival_json(s.rest);
  json["terminal_error_m"] = s.rest ? ordered_json(s.rest->target_error_m) : ordered_json();
  json["terminal_max_m"] = s.rest ? ordered_json(s.rest->target_max_m) : ordered_json();
  if (is_mission_file(request.instruction)) {
    json["targets"] = ordered_json::array();
    for (const TargetScore& target : s.targets) json["targets"].push_back(to_json(target));
  }
  json["duration_s"] = s.duration_s;
  json["distance_m"] = s.distance_m;
  json["legs"] = ordered_json::array();
  for (const LegScore& leg : s.track.legs) json["legs"].push_back(to_json(leg));
  json["tracking"] = to_json(s.track.all);
  json["junctions"] = to_json(s.junctions);
  json["timing"] = to_json(s.timing, s.duration_s);
  json["trajectory_sha256"] = s.trajectory_sha256;
  return json;
}

}  // namespace lineservo::apps
