#include "servo/law/dock_law.h"

namespace lineservo::servo {

DockLaw::DockLaw(const DockOptions& options)
    : options_(options),
      on_line_(options.gain, PointTask::Heading::on_line),
      turning_(options.gain, PointTask::Heading::free),
      drift_x_(options.drift_time_constant_s, options.drift_limit_m_s),
      drift_y_(drift_x_) {}

void DockLaw::reset() {
  drift_x_ = drift_y_ = DriftObserver(options_.drift_time_constant_s, options_.drift_limit_m_s);
  last_captured_.reset();
}

// The vehicle's place against the node, in the odometry's directions: −R(ψ) p.
void DockLaw::observe(const Observation& observation, const Eigen::Vector2d& point_at_capture_m) {
  const Motion& odometry = observation.estimate.odometry_at_capture;
  const Eigen::Vector2d place_m = -(Eigen::Rotation2Dd(odometry.yaw_rad) * point_at_capture_m);
  if (!place_m.allFinite()) return;
  if (last_captured_ && *last_captured_ >= observation.captured) return;
  const double dt_s = last_captured_ ? seconds(observation.captured - *last_captured_) : 0.0;
  const Eigen::Vector2d step_m = odometry.translation_m - last_odometry_.translation_m;
  drift_x_.update(place_m.x(), step_m.x(), dt_s);
  drift_y_.update(place_m.y(), step_m.y(), dt_s);
  last_captured_ = observation.captured;
  last_odometry_ = odometry;
}

VelocityCommand DockLaw::hold(const Observation& observation, const DockGoal& goal) {
  PointTask& task = goal.theta_rad ? on_line_ : turning_;
  const TaskSolution solution =
      task.solve(level_point(goal.point_H_m, observation.estimate.height_m), goal.theta_rad.value_or(0.0),
                 observation.estimate.height_m, goal.height_m, goal.yaw_rate_rad_s,
                 drift_H_m_s(observation) - goal.velocity_H_m_s);
  return solution.valid ? solution.command : VelocityCommand{};
}

Eigen::Vector2d DockLaw::drift_H_m_s(const Observation& observation) const {
  return Eigen::Rotation2Dd(-observation.estimate.odometry_now.yaw_rad) *
         Eigen::Vector2d(drift_x_.drift_m_s(), drift_y_.drift_m_s());
}

}  // namespace lineservo::servo
