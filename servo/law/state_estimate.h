#pragma once

#include <Eigen/Core>

#include "servo/law/motion.h"

namespace lineservo::servo {

/// What the vehicle believes of itself at one control tick: all that reaches its computer beside the frame,
/// and goes from there to the laws as one value. Never truth.
struct StateEstimate {
  Motion odometry_now;  ///< dead reckoning by the velocity and yaw estimates since the flight began; drifts
  Motion odometry_at_capture;  ///< the same when the frame was taken
  double height_m = 0.0;       ///< now
  double capture_height_m = 0.0;
  Eigen::Vector3d v_H_m_s = Eigen::Vector3d::Zero();
  /// For how long no sensor has told the height and the velocity.
  double height_age_s = 0.0, velocity_age_s = 0.0;
};

}  // namespace lineservo::servo
