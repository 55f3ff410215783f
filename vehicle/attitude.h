#pragma once

#include <Eigen/Geometry>

namespace lineservo::vehicle {

/// Roll, pitch and yaw of B in W: R_WB = R_z(yaw) R_y(pitch) R_x(roll). With z up and y left, positive pitch
/// is nose down and accelerates forward, positive roll accelerates to the right.
struct RollPitchYaw {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
};

RollPitchYaw roll_pitch_yaw(const Eigen::Quaterniond& q_WB);
Eigen::Quaterniond quaternion(const RollPitchYaw& angles);

/// R_HB: the body in the heading frame.
Eigen::Quaterniond tilt_q_HB(double roll_rad, double pitch_rad);

/// The rotation by the vector (axis times angle).
Eigen::Quaterniond rotation(const Eigen::Vector3d& angle_vector_rad);

/// The angle between z_B and the vertical.
double tilt_rad(const Eigen::Quaterniond& q_WB);

/// The vector turned about the vertical.
Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle_rad);

/// What yaw rate a body rate amounts to, and the other Euler rates.
RollPitchYaw euler_rates(const Eigen::Vector3d& w_B_rad_s, double roll_rad, double pitch_rad);

}  // namespace lineservo::vehicle
