#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <variant>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// The true motion of the body B in the world W. For scoring and for the simulated sensors only.
struct BodyState {
  Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d w_B = Eigen::Vector3d::Zero();
};

/// What the vehicle believes of itself. H is the heading frame: z up, x the horizontal projection of x_B.
struct Estimate {
  Time stamp{0};
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;  ///< integrated gyro, drifts
  Eigen::Vector3d w_B_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d v_H_m_s = Eigen::Vector3d::Zero();
  double height_m = 0.0;  ///< of the body origin above the floor
};

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

/// What the autopilot is doing.
enum class AutopilotMode { idle, tracking, braking, landing, landed };

}  // namespace lineservo::vehicle
