#include "servo/executive/node_tracker.h"

namespace lineservo::servo {
namespace {

Eigen::Vector2d to_origin(const Motion& pose, const Eigen::Vector2d& p_H) {
  return pose.translation_m + Eigen::Rotation2Dd(pose.yaw_rad) * p_H;
}

}  // namespace

bool NodeTracker::observe(const Observation& observation, const std::optional<Eigen::Vector2d>& sighting_m) {
  if (node_O_ && seconds(observation.captured - seen_) > options_.memory_s) node_O_.reset();
  if (!sighting_m || !sighting_m->allFinite()) return false;
  const Eigen::Vector2d sighting_O = to_origin(observation.estimate.odometry_at_capture, *sighting_m);
  if (node_O_ && (sighting_O - *node_O_).norm() > options_.gate_m) return false;
  if (node_O_ && jumps(sighting_O)) return false;
  node_O_ = node_O_ ? Eigen::Vector2d(*node_O_ + options_.weight * (sighting_O - *node_O_)) : sighting_O;
  seen_ = observation.captured;
  return true;
}

// Of worn paint one frame in many misplaces a border by the size of a blotch.
bool NodeTracker::jumps(const Eigen::Vector2d& sighting_O) {
  const auto apart = [&](const std::optional<Eigen::Vector2d>& p_O) {
    return !p_O || (sighting_O - *p_O).norm() > options_.jump_m;
  };
  if (apart(node_O_) && apart(jumped_to_O_)) {
    jumped_to_O_ = sighting_O;
    return true;
  }
  jumped_to_O_.reset();
  return false;
}

std::optional<Eigen::Vector2d> NodeTracker::node_now(const Observation& observation) const {
  if (!node_O_) return std::nullopt;
  return after(observation.estimate.odometry_now, *node_O_);
}

std::optional<Eigen::Vector2d> NodeTracker::node_at_capture(const Observation& observation) const {
  if (!node_O_) return std::nullopt;
  return after(observation.estimate.odometry_at_capture, *node_O_);
}

}  // namespace lineservo::servo
