#include "servo/executive/sighting.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

/// Nearer than this a disc is told, in heights: 0.2 m at 0.5 m, about where a cross is.
constexpr double kDiscNear_heights = 0.4;

// Bounds of a bend as seen: those of the plan (25° to 65°), with the yaw that is left.
constexpr double kBackArm_rad = features::radians(30.0);
constexpr double kLeastBend_rad = features::radians(20.0);
constexpr double kSharpestBend_rad = features::radians(70.0);

// Of a fork: how far off an arm may be seen, and how near its node is, in heights.
constexpr double kForkArm_rad = features::radians(18.0);
constexpr double kForkNear_heights = 0.6;

constexpr double kImageCentre_px = 199.5;
constexpr double kBendCentroid_px = 45.0;  // Γ/(2h) of topology §2.5
constexpr double kOnLine_px = 10.0;

bool expects_disc(const PlanStep* step) {
  return step && step->expected.code == features::JunctionCode::start;
}

bool is_pursued(const PlanStep* step) {
  return step && step->pursued;
}

bool expects_dead_end(const PlanStep* step) {
  return step && step->expected.line_ends && step->expected.code == features::JunctionCode::straight;
}

bool expects_bend(const PlanStep* step) {
  return step && step->expected.bend != Bend::none;
}

features::CodeReading plain_line() {
  features::CodeReading reading;
  reading.smoothed = features::JunctionCode::straight;
  return reading;
}

bool expects_fork(const PlanStep* step) {
  return step && step->expected.bend == Bend::fork;
}

/// By two arms, of which one leads back and the other ahead to a side.
Bend bend_of(const std::vector<features::ArmFeature>& arms) {
  if (arms.size() != 2) return Bend::none;
  const bool first_is_back = std::abs(arms[0].angle_rad) > std::abs(arms[1].angle_rad);
  const double back_rad = arms[first_is_back ? 0 : 1].angle_rad;
  const double ahead_rad = arms[first_is_back ? 1 : 0].angle_rad;
  const bool bends = features::kPi - std::abs(back_rad) < kBackArm_rad &&
                     std::abs(ahead_rad) > kLeastBend_rad && std::abs(ahead_rad) < kSharpestBend_rad;
  if (!bends) return Bend::none;
  return ahead_rad > 0.0 ? Bend::left : Bend::right;
}

bool is_fork(const features::JunctionFeature& junction, const std::vector<double>& arms_rad) {
  if (junction.centre.vector().norm() > kForkNear_heights || junction.arms.size() != arms_rad.size())
    return false;
  return std::all_of(arms_rad.begin(), arms_rad.end(), [&junction](double arm_rad) {
    return std::any_of(junction.arms.begin(), junction.arms.end(), [arm_rad](const auto& seen) {
      return std::abs(features::wrap_angle(seen.angle_rad - arm_rad)) < kForkArm_rad;
    });
  });
}

}  // namespace

std::optional<Eigen::Vector2d> disc_sighting(const Observation& o) {
  if (!o.features.start_marker) return std::nullopt;
  return floor_point_m(*o.features.start_marker, o.estimate.capture_height_m);
}

features::CodeReading near_reading(const Observation& o, const PlanStep* step) {
  features::CodeReading reading = o.features.code;
  if (is_pursued(step) && reading.smoothed != features::JunctionCode::start) return plain_line();
  if (expects_fork(step)) reading.smoothed = features::JunctionCode::straight;  // its codes mean nothing
  if (expects_bend(step) && reading.smoothed == features::JunctionCode::straight)
    reading.line_ends_ahead = false;
  if (reading.smoothed != features::JunctionCode::start) return reading;
  const auto disc = disc_sighting(o);
  const bool is_near = disc && disc->norm() < kDiscNear_heights * o.estimate.capture_height_m;
  if (!expects_disc(step) || !is_near) reading.smoothed = features::JunctionCode::unrecognised;
  return reading;
}

std::optional<Eigen::Vector2d> node_sighting(const Observation& o, const PlanStep* step) {
  if (expects_disc(step)) return disc_sighting(o);
  if (o.features.junction) return floor_point_m(o.features.junction->centre, o.estimate.capture_height_m);
  if (expects_dead_end(step) && line_to_follow(o) && o.features.code.line_ends_ahead) {
    return floor_point_m(line_to_follow(o)->end, o.estimate.capture_height_m);
  }
  return std::nullopt;
}

std::optional<Eigen::Vector2d> dead_end_sighting(const Observation& o, const PlanStep* step,
                                                 const std::optional<Eigen::Vector2d>& where_m) {
  if (!expects_dead_end(step) || !where_m) return std::nullopt;
  std::optional<Eigen::Vector2d> nearest_m;
  for (const features::LineFeature& line : o.features.lines) {
    for (const features::LevelPoint& end : {line.begin, line.end}) {
      const Eigen::Vector2d end_m = floor_point_m(end, o.estimate.capture_height_m);
      if (!nearest_m || (end_m - *where_m).norm() < (*nearest_m - *where_m).norm()) nearest_m = end_m;
    }
  }
  return nearest_m;
}

Bend bend_sighting(const Observation& o, const PlanStep* step) {
  if (!expects_bend(step) || !o.features.junction) return Bend::none;
  if (expects_fork(step))
    return is_fork(*o.features.junction, step->expected.arms_rad) ? Bend::fork : Bend::none;
  return bend_of(o.features.junction->arms);
}

Bend CentroidBend::update(const Observation& o, const PlanStep* step, bool leaving) {
  if (leaving || !expects_bend(step)) was_on_line_ = false;
  if (leaving || !expects_bend(step) || !o.features.centroid_px) return Bend::none;
  const double off_px = o.features.centroid_px->x - kImageCentre_px;
  was_on_line_ |= std::abs(off_px) < kOnLine_px;
  if (!was_on_line_ || std::abs(off_px) <= kBendCentroid_px) return Bend::none;
  return off_px < 0.0 ? Bend::left : Bend::right;
}

}  // namespace lineservo::servo
