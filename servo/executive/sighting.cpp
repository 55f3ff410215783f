#include "servo/executive/sighting.h"

namespace lineservo::servo {
namespace {

/// Nearer than this a disc is told, in heights: 0.2 m at 0.5 m, about where a cross is.
constexpr double kDiscNear_heights = 0.4;

bool expects_disc(const PlanStep* step) {
  return step && step->expected.code == features::JunctionCode::start;
}

}  // namespace

std::optional<Eigen::Vector2d> disc_sighting(const Observation& o) {
  if (!o.features.start_marker) return std::nullopt;
  return floor_point_m(*o.features.start_marker, o.capture_height_m);
}

features::CodeReading near_reading(const Observation& o, const PlanStep* step) {
  features::CodeReading reading = o.features.code;
  if (reading.smoothed != features::JunctionCode::start) return reading;
  const auto disc = disc_sighting(o);
  const bool is_near = disc && disc->norm() < kDiscNear_heights * o.capture_height_m;
  if (!expects_disc(step) || !is_near) reading.smoothed = features::JunctionCode::unrecognised;
  return reading;
}

std::optional<Eigen::Vector2d> node_sighting(const Observation& o, const PlanStep* step) {
  if (expects_disc(step)) return disc_sighting(o);
  if (o.features.junction) return floor_point_m(o.features.junction->centre, o.capture_height_m);
  const bool dead_end =
      step && step->expected.line_ends && step->expected.code == features::JunctionCode::straight;
  if (dead_end && line_to_follow(o) && o.features.code.line_ends_ahead) {
    return floor_point_m(line_to_follow(o)->end, o.capture_height_m);
  }
  return std::nullopt;
}

}  // namespace lineservo::servo
