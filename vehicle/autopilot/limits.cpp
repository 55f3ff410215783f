#include "vehicle/autopilot/limits.h"

#include <algorithm>

namespace lineservo::vehicle {

double climb_rate_to(double height_m, const Estimate& estimate, const SafetyLimits& limits) {
  const double rate = kHeightGain_per_s * (std::min(height_m, limits.max_height_m) - estimate.height_m);
  return std::clamp(rate, -limits.max_vertical_speed_m_s, limits.max_vertical_speed_m_s);
}

VelocitySetpoint limited(VelocitySetpoint s, const Estimate& estimate, const SafetyLimits& limits) {
  s.v_H_m_s.head<2>() = shortened(s.v_H_m_s.head<2>(), limits.max_horizontal_speed_m_s);
  const double highest_climb = climb_rate_to(limits.max_height_m, estimate, limits);
  s.v_H_m_s.z() = std::min(std::max(s.v_H_m_s.z(), -limits.max_vertical_speed_m_s), highest_climb);
  s.yaw_rate_rad_s = std::clamp(s.yaw_rate_rad_s, -limits.max_yaw_rate_rad_s, limits.max_yaw_rate_rad_s);
  return s;
}

AttitudeSetpoint limited(AttitudeSetpoint s, const SafetyLimits& limits) {
  const Eigen::Vector2d tilt = shortened({s.roll_rad, s.pitch_rad}, limits.max_tilt_rad);
  s.roll_rad = tilt.x();
  s.pitch_rad = tilt.y();
  s.yaw_rate_rad_s = std::clamp(s.yaw_rate_rad_s, -limits.max_yaw_rate_rad_s, limits.max_yaw_rate_rad_s);
  s.height_m = std::min(s.height_m, limits.max_height_m);
  return s;
}

Eigen::Vector2d speed_limited(const Eigen::Vector2d& a_H_m_s2, const Estimate& estimate, double gain_per_s,
                              const SafetyLimits& limits) {
  const Eigen::Vector2d v_H = estimate.v_H_m_s.head<2>();
  const double speed = v_H.norm();
  if (speed < 1e-6) return a_H_m_s2;
  const Eigen::Vector2d along = v_H / speed;
  const double allowed = gain_per_s * (limits.max_horizontal_speed_m_s - speed);
  return a_H_m_s2 - std::max(0.0, a_H_m_s2.dot(along) - allowed) * along;
}

Eigen::Vector2d shortened(const Eigen::Vector2d& v, double longest) {
  const double length = v.norm();
  return length > longest ? Eigen::Vector2d(v * (longest / length)) : v;
}

}  // namespace lineservo::vehicle
