#include "vehicle/autopilot/attitude_controller.h"

#include <algorithm>
#include <cmath>

#include "vehicle/attitude.h"
#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {

// z_B in H is (cosφ sinθ, −sinφ, cosφ cosθ).
TiltTarget tilt_for(const Eigen::Vector3d& thrust_direction_H) {
  const Eigen::Vector3d z = thrust_direction_H.normalized();
  return {-std::asin(std::clamp(z.y(), -1.0, 1.0)), std::atan2(z.x(), z.z())};
}

Eigen::Vector2d acceleration_of(const TiltTarget& tilt) {
  return kGravity_m_s2 *
         Eigen::Vector2d(std::tan(tilt.pitch_rad), -std::tan(tilt.roll_rad) / std::cos(tilt.pitch_rad));
}

double thrust_for(double mass_kg, double vertical_m_s2, const Estimate& estimate) {
  const double cosine = std::cos(estimate.roll_rad) * std::cos(estimate.pitch_rad);
  return mass_kg * std::max(vertical_m_s2, 0.0) / std::max(cosine, 0.5);
}

Eigen::Vector3d body_rates_for(const TiltTarget& target, double yaw_rate_rad_s, const Estimate& estimate,
                               double gain_per_s) {
  const Eigen::Quaterniond q_HB = tilt_q_HB(estimate.roll_rad, estimate.pitch_rad);
  const Eigen::Quaterniond error = q_HB.conjugate() * tilt_q_HB(target.roll_rad, target.pitch_rad);
  const double sign = error.w() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d yaw_rate_H(0.0, 0.0, yaw_rate_rad_s);
  return 2.0 * gain_per_s * sign * error.vec() + q_HB.conjugate() * yaw_rate_H;
}

}  // namespace lineservo::vehicle
