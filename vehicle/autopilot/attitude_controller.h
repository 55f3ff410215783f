#pragma once

#include "vehicle/estimate.h"

namespace lineservo::vehicle {

/// Where to tilt.
struct TiltTarget {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

/// The tilt whose thrust has this direction in the heading frame.
TiltTarget tilt_for(const Eigen::Vector3d& thrust_direction_H);
/// The horizontal acceleration in hover with this tilt, and back.
Eigen::Vector2d acceleration_of(const TiltTarget& tilt);

/// The thrust that balances this vertical acceleration (gravity included) at the tilt.
double thrust_for(double mass_kg, double vertical_m_s2, const Estimate& estimate);

/// Tilt and yaw rate → body rates: w = 2 k sgn(q_w) q_xyz of the tilt error, plus the yaw rate about the
/// vertical.
Eigen::Vector3d body_rates_for(const TiltTarget& target, double yaw_rate_rad_s, const Estimate& estimate,
                               double gain_per_s);

}  // namespace lineservo::vehicle
