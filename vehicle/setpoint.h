#pragma once

#include <Eigen/Core>
#include <variant>

namespace lineservo::vehicle {

/// Velocity in the heading frame and yaw rate.
struct VelocitySetpoint {
  Eigen::Vector3d v_H_m_s = Eigen::Vector3d::Zero();
  double yaw_rate_rad_s = 0.0;
};

/// Roll, pitch, yaw rate and height, as attitude-level followers command.
struct AttitudeSetpoint {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rate_rad_s = 0.0;
  double height_m = 0.5;
};

/// Descend where it is and stop the motors on the ground.
struct LandSetpoint {};

using Setpoint = std::variant<LandSetpoint, VelocitySetpoint, AttitudeSetpoint>;

/// No NaN and no infinity in it.
bool is_finite(const Setpoint& setpoint);

}  // namespace lineservo::vehicle
