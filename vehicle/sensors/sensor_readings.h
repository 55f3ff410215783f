#pragma once

#include <Eigen/Core>
#include <optional>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// What the sensors say at one instant. Flow and range answer less often than the inertial unit.
struct SensorReadings {
  Time stamp{0};
  Eigen::Vector3d gyro_B_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_B_m_s2 = Eigen::Vector3d::Zero();  ///< mean over the inertial period
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  std::optional<Eigen::Vector2d> flow_v_H_m_s;
  std::optional<double> range_m;  ///< along −z_B from the body origin to the floor
};

}  // namespace lineservo::vehicle
