#pragma once

#include <Eigen/Core>
#include <optional>

#include "servo/law/drift_observer.h"
#include "servo/law/observation.h"
#include "servo/task/point_task.h"

namespace lineservo::servo {

/// Gain and drift observer of docking, of the settings servo.dock.*.
struct DockOptions {
  AdaptiveGain gain = {2.0, 0.9, 2.0};
  double drift_time_constant_s = 0.25;
  double drift_limit_m_s = 0.3;
};

/// What the executive asks of docking, one tick.
struct DockGoal {
  Eigen::Vector2d point_H_m = Eigen::Vector2d::Zero();  ///< the node's centre now, heading frame
  std::optional<double> theta_rad;                      ///< the line's angle now, to be brought to zero
  double yaw_rate_rad_s = 0.0;                          ///< when no angle is given: turn about the node
  double height_m = 0.5;
  Eigen::Vector2d velocity_H_m_s = Eigen::Vector2d::Zero();  ///< with which the goal moves, heading frame
};

/// Brings the vehicle to rest above a floor point and holds it there, or moves along with it, on the line's
/// heading or while it turns: the ViSP point task, with the drift of the odometry fed forward.
class DockLaw {
 public:
  explicit DockLaw(const DockOptions& options);

  void reset();
  /// Tells where the node's centre was in a frame (heading frame of that instant, metres), to learn the drift
  /// from.
  void observe(const Observation& observation, const Eigen::Vector2d& point_at_capture_m);
  VelocityCommand hold(const Observation& observation, const DockGoal& goal);
  /// The motion that the odometry does not know of (forward, left), as learnt so far.
  Eigen::Vector2d drift_H_m_s(const Observation& observation) const;

 private:
  DockOptions options_;
  PointTask on_line_;
  PointTask turning_;
  DriftObserver drift_x_, drift_y_;  ///< in the odometry's frame, so that a turn leaves them in place
  std::optional<Time> last_captured_;
  Motion last_odometry_;
};

}  // namespace lineservo::servo
