#include "apps/evaluate/fault_cases.h"

#include <fmt/format.h>

#include <numeric>

#include "apps/scoring/route_truth.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using Settings = std::vector<std::string>;
using vehicle::Random;

constexpr double kForGood_s = 36000.0;
constexpr double kOnTheGround_s = 10.0;  // take-off, aligning and hovering

double way_m(const Mission& mission) {
  double sum_m = 0.0;
  for (const servo::PlanStep& step : mission.plan.steps) sum_m += step.edge_length_m;
  return sum_m;
}

double likely_duration_s(const Mission& mission) {
  return kOnTheGround_s + way_m(mission) / mission.request.settings.speed_m_s;
}

std::string setting(const std::string& key, double value) {
  return fmt::format("faults.{}={:.3f}", key, value);
}

/// From an instant of the flight on.
FaultCase at_any_time(const std::string& key, double duration_s) {
  const std::string length = duration_s < kForGood_s ? fmt::format("{} s", duration_s) : "for good";
  return {key + " " + length, [key, duration_s](const Mission& mission, Random& random) -> Settings {
            const double start_s = random.uniform(0.0, likely_duration_s(mission));
            return {setting(key + ".start_s", start_s), setting(key + ".duration_s", duration_s)};
          }};
}

/// A place of the way and the direction of travel there.
vehicle::CurvePoint drawn_place(const Mission& mission, Random& random) {
  const RouteTruth route = route_truth(mission.floor, mission.plan);
  double s_m = random.uniform(0.0, way_m(mission));
  for (const LegTruth& leg : route.legs) {
    for (const TravelledEdge& edge : leg.edges) {
      if (s_m <= edge.curve->length_m()) return travelled_point(edge, s_m);
      s_m -= edge.curve->length_m();
    }
  }
  return travelled_point(route.legs.back().edges.back(), route.legs.back().edges.back().curve->length_m());
}

Eigen::Vector2d drawn_node(const Mission& mission, Random& random) {
  const RouteTruth route = route_truth(mission.floor, mission.plan);
  const auto k = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(route.nodes.size())));
  return mission.floor.nodes[route.nodes[k]].p_W;
}

Settings cover(const Eigen::Vector2d& p_W, double radius_m) {
  return {setting("cover.x_m", p_W.x()), setting("cover.y_m", p_W.y()), setting("cover.radius_m", radius_m)};
}

Settings node_covered(const Mission& mission, Random& random) {
  const Eigen::Vector2d node_W = drawn_node(mission, random);
  return cover(node_W, random.uniform(0.2, 0.8));
}

Settings line_covered(const Mission& mission, Random& random) {
  const Eigen::Vector2d place_W = drawn_place(mission, random).p_W;
  return cover(place_W, random.uniform(0.2, 2.0));
}

Settings branch(const vehicle::CurvePoint& from, double off_deg, double length_m) {
  return {setting("branch.x_m", from.p_W.x()), setting("branch.y_m", from.p_W.y()),
          setting("branch.heading_deg", features::degrees(features::wrap_angle(from.heading_rad)) + off_deg),
          setting("branch.length_m", length_m)};
}

/// Two branches that look alike: one more leaves the line ahead, at 20 to 60° to a side.
Settings branch_ahead(const Mission& mission, Random& random) {
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  const double off_deg = side * random.uniform(20.0, 60.0);
  return branch(drawn_place(mission, random), off_deg, random.uniform(1.0, 4.0));
}

/// A junction where the floor has none.
Settings branch_aside(const Mission& mission, Random& random) {
  const double off_deg = random.uniform() < 0.5 ? -90.0 : 90.0;
  return branch(drawn_place(mission, random), off_deg, random.uniform(1.0, 4.0));
}

Settings misread_code(const Mission& mission, Random& random) {
  constexpr const char* kCodes[] = {"J2", "J3", "J4", "J5", "J7", "J8", "J9"};
  Settings settings = at_any_time("misread", random.uniform(0.2, 2.0)).draw(mission, random);
  const auto k = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(std::size(kCodes))));
  settings.push_back(fmt::format("faults.misread.code={}", kCodes[k]));
  return settings;
}

Settings battery(const Mission& mission, Random& random) {
  return {
      fmt::format("executive.endurance_s={:.1f}", random.uniform(20.0, 20.0 + likely_duration_s(mission)))};
}

std::vector<FaultCase> make_cases() {
  std::vector<FaultCase> cases = {{"none", [](const Mission&, Random&) { return Settings{}; }}};
  for (const char* key : {"camera_black", "camera_frozen", "camera_silent", "features_nan"}) {
    cases.push_back(at_any_time(key, 1.0));
    cases.push_back(at_any_time(key, kForGood_s));
  }
  for (const char* key : {"range_silent", "velocity_silent", "estimate_nan", "law_nan"}) {
    cases.push_back(at_any_time(key, 0.4));
    cases.push_back(at_any_time(key, kForGood_s));
  }
  for (const char* key : {"frames_late", "frames_twice", "range_frozen", "range_wild", "attitude_silent",
                          "gyro_wild", "sensors_nan"})
    cases.push_back(at_any_time(key, kForGood_s));
  cases.push_back({"code misread", misread_code});
  cases.push_back({"junction painted over", node_covered});
  cases.push_back({"line painted over", line_covered});
  cases.push_back({"branch ahead", branch_ahead});
  cases.push_back({"branch aside", branch_aside});
  cases.push_back({"battery", battery});
  return cases;
}

}  // namespace

const std::vector<FaultCase>& fault_cases() {
  static const std::vector<FaultCase> kCases = make_cases();
  return kCases;
}

}  // namespace lineservo::apps
