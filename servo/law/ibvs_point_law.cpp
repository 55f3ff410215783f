#include "servo/law/ibvs_point_law.h"

#include <algorithm>
#include <cmath>

#include "servo/law/height_rate.h"

namespace lineservo::servo {

using features::JunctionCode;
using features::LevelPoint;

IbvsPointLaw::IbvsPointLaw(PathPoint which, const IbvsPointOptions& options)
    : which_(which),
      options_(options),
      task_(options.gain),
      drift_(options.drift_time_constant_s, options.drift_limit_m_s),
      junction_drift_(options.junction_drift_time_constant_s, options.drift_limit_m_s) {}

void IbvsPointLaw::reset() {
  last_.reset();
  drift_ = DriftObserver(options_.drift_time_constant_s, options_.drift_limit_m_s);
  junction_drift_ = DriftObserver(options_.junction_drift_time_constant_s, options_.drift_limit_m_s);
}

Command IbvsPointLaw::follow(const Observation& observation, const FollowGoal& goal) {
  const std::optional<LevelPoint> point = point_now(observation);
  const double climb_m_s = height_rate(observation.estimate.height_m, goal.height_m);
  if (!point && !line_to_follow(observation)) return VelocityCommand{0.0, 0.0, climb_m_s, 0.0};
  if (!point) return VelocityCommand{goal.speed_m_s, -drift_m_s(observation), climb_m_s, goal.yaw_rate_rad_s};
  const double offset = point->x / options_.view_margin;
  const double forward_m_s = goal.speed_m_s * std::clamp(1.0 - offset * offset, 0.0, 1.0);
  const TaskSolution solution = task_.solve(*point, observation.estimate.height_m, goal.height_m,
                                            {forward_m_s, goal.yaw_rate_rad_s, drift_m_s(observation)});
  return solution.valid ? solution.command : VelocityCommand{};
}

const LevelPoint* IbvsPointLaw::usable_point(const Observation& observation) const {
  const features::FrameFeatures& seen = observation.features;
  const bool is_plain_line = seen.code.raw == JunctionCode::straight &&
                             seen.code.smoothed == JunctionCode::straight && seen.lines.size() <= 1 &&
                             !seen.junction;
  const auto& point = which_ == PathPoint::centroid ? seen.law.centroid : seen.law.target;
  return is_plain_line && point && point->vector().allFinite() ? &*point : nullptr;
}

std::optional<LevelPoint> IbvsPointLaw::point_now(const Observation& observation) {
  const LevelPoint* seen = usable_point(observation);
  const bool is_new = !last_ || observation.captured > last_->captured;
  if (seen && is_new) {
    const Eigen::Vector2d point_m = floor_point_m(*seen, observation.estimate.capture_height_m);
    observe_drift(observation, point_m);
    last_ = {point_m, observation.captured, observation.estimate.odometry_at_capture};
  }
  if (!last_ || seconds(observation.now - last_->captured) > options_.coast_s) return std::nullopt;
  Eigen::Vector2d point_m =
      after(between(last_->odometry, observation.estimate.odometry_now), last_->point_m);
  point_m.y() -= drift_m_s(observation) * seconds(observation.now - last_->captured);
  return level_point(point_m, observation.estimate.height_m);
}

double IbvsPointLaw::drift_m_s(const Observation& observation) const {
  const bool counts = last_ && last_->captured >= observation.captured;
  return counts ? drift_.drift_m_s() : junction_drift_.drift_m_s();
}

// The vehicle's place to the left of the point is minus the point's own. Odometry moves the point as one that
// is fixed to the floor; that the path's point slides along a path which is not straight ahead shows as drift
// as well, and is fed forward all the same.
void IbvsPointLaw::observe_drift(const Observation& observation, const Eigen::Vector2d& point_m) {
  const double gap_s = last_ ? seconds(observation.captured - last_->captured) : 0.0;
  const bool goes_on = last_ && gap_s <= options_.coast_s;
  const Motion moved =
      goes_on ? between(last_->odometry, observation.estimate.odometry_at_capture) : Motion{};
  const double step_m = goes_on ? last_->point_m.y() - after(moved, last_->point_m).y() : 0.0;
  for (DriftObserver* drift : {&drift_, &junction_drift_}) {
    if (!goes_on) drift->restart();
    drift->update(-point_m.y(), step_m, gap_s);
  }
}

}  // namespace lineservo::servo
