#include "vehicle/attitude.h"

#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {

RollPitchYaw roll_pitch_yaw(const Eigen::Quaterniond& q_WB) {
  const Eigen::Matrix3d R = q_WB.toRotationMatrix();
  return {std::atan2(R(2, 1), R(2, 2)), -std::asin(std::clamp(R(2, 0), -1.0, 1.0)),
          std::atan2(R(1, 0), R(0, 0))};
}

Eigen::Quaterniond quaternion(const RollPitchYaw& angles) {
  const Eigen::Quaterniond q_yaw(std::cos(angles.yaw_rad / 2), 0, 0, std::sin(angles.yaw_rad / 2));
  return q_yaw * tilt_q_HB(angles.roll_rad, angles.pitch_rad);
}

Eigen::Quaterniond tilt_q_HB(double roll_rad, double pitch_rad) {
  const double cr = std::cos(roll_rad / 2), sr = std::sin(roll_rad / 2);
  const double cp = std::cos(pitch_rad / 2), sp = std::sin(pitch_rad / 2);
  return {cp * cr, cp * sr, sp * cr, -sp * sr};
}

Eigen::Quaterniond rotation(const Eigen::Vector3d& angle_vector_rad) {
  const double half_rad = 0.5 * angle_vector_rad.norm();
  // sin(x)/x = 1 − x²/6 to the last bit below 1e-4.
  const double sinc = half_rad < 1e-4 ? 1.0 - half_rad * half_rad / 6.0 : std::sin(half_rad) / half_rad;
  const Eigen::Vector3d xyz = 0.5 * sinc * angle_vector_rad;
  return {std::cos(half_rad), xyz.x(), xyz.y(), xyz.z()};
}

double tilt_rad(const Eigen::Quaterniond& q_WB) {
  // z_W · z_B = 1 − 2(x² + y²)
  const double cosine = 1.0 - 2.0 * (q_WB.x() * q_WB.x() + q_WB.y() * q_WB.y());
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

RollPitchYaw euler_rates(const Eigen::Vector3d& w_B_rad_s, double roll_rad, double pitch_rad) {
  // ψ̇ = (q sinφ + r cosφ)/cosθ;  θ̇ = q cosφ − r sinφ;  φ̇ = p + ψ̇ sinθ
  const double s = std::sin(roll_rad), c = std::cos(roll_rad);
  const double yaw_rate = (w_B_rad_s.y() * s + w_B_rad_s.z() * c) / std::max(std::cos(pitch_rad), 0.05);
  return {w_B_rad_s.x() + yaw_rate * std::sin(pitch_rad), w_B_rad_s.y() * c - w_B_rad_s.z() * s, yaw_rate};
}

}  // namespace lineservo::vehicle
