#include "servo/law/vtp_law.h"

#include <cmath>

#include "servo/law/height_rate.h"

namespace lineservo::servo {
namespace {

constexpr double kJitter_s = 0.005;  // by which a frame may come early for its step

}  // namespace

void VtpLaw::reset() {
  stepped_.reset();
  error_px_.reset();
  step_H_m_.setZero();
}

Command VtpLaw::follow(const Observation& observation, const FollowGoal& goal) {
  if (step_is_due(observation)) {
    step_H_m_ = step_m(observation.features.law.target);
    stepped_ = observation.captured;
  }
  return step_towards(observation, goal, goal.speed_m_s / published_speed_m_s(options_));
}

// w_k+1 = w_k + 0.0022·e, with the marker's centre e in pixels (published code).
std::optional<Command> VtpLaw::hover(const Observation& observation, const FollowGoal& goal) {
  const auto& marker = observation.features.start_marker;
  if (!marker || !marker->vector().allFinite()) return std::nullopt;
  if (step_is_due(observation)) {
    const Eigen::Vector2d error_px = options_.focal_px * Eigen::Vector2d(-marker->y, -marker->x);
    step_H_m_ = options_.marker_step_m_per_px * error_px;
    stepped_ = observation.captured;
  }
  return step_towards(observation, goal, 1.0);
}

VelocityCommand VtpLaw::step_towards(const Observation& observation, const FollowGoal& goal,
                                     double scale) const {
  const Eigen::Vector2d v_H_m_s = scale * step_H_m_ / options_.period_s;
  return {v_H_m_s.x(), v_H_m_s.y(), height_rate(observation.estimate.height_m, goal.height_m), 0.0};
}

bool VtpLaw::step_is_due(const Observation& observation) const {
  return !stepped_ || seconds(observation.captured - *stepped_) >= options_.period_s - kJitter_s;
}

// w_k+1 = w_k + 0.0038·e + 0.002·Δe for each axis, the second term when |Δe| ≥ 2 px (published code). Without
// a target there is no step: the vehicle stays.
Eigen::Vector2d VtpLaw::step_m(const std::optional<features::LevelPoint>& target) {
  const bool is_usable = target && target->vector().allFinite() && target->vector().norm() > 0.0;
  if (!is_usable) {
    error_px_.reset();
    return Eigen::Vector2d::Zero();
  }
  const Eigen::Vector2d direction = Eigen::Vector2d(-target->y, -target->x).normalized();
  const Eigen::Vector2d error_px = options_.arc_px * direction;
  Eigen::Vector2d step = options_.step_m_per_px * error_px;
  for (int axis = 0; axis < 2; ++axis) {
    const double change_px = error_px_ ? error_px[axis] - (*error_px_)[axis] : 0.0;
    if (std::abs(change_px) >= options_.change_px) step[axis] += options_.change_m_per_px * change_px;
  }
  error_px_ = error_px;
  return step;
}

}  // namespace lineservo::servo
