#pragma once

#include <Eigen/Core>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// What the vehicle believes of itself. H is the heading frame: z up, x the horizontal projection of x_B.
struct Estimate {
  Time stamp{0};
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;  ///< integrated gyro: 0 at power-on, drifts, counts on past ±π
  Eigen::Vector3d w_B_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d v_H_m_s = Eigen::Vector3d::Zero();
  /// Horizontal specific force, bias-corrected, which is the horizontal acceleration. As noisy as the
  /// accelerometer.
  Eigen::Vector2d a_H_m_s2 = Eigen::Vector2d::Zero();
  double height_m = 0.0;  ///< of the body origin above the floor
  /// Since when nothing stands behind the height and the velocity but the accelerometer.
  Time range_heard{0}, flow_heard{0};
};

}  // namespace lineservo::vehicle
