#pragma once

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {

/// Gains of the cascade, computed from the airframe's lags: each loop a fixed factor slower than the one
/// inside.
struct Gains {
  double rotor_lag_s = 0.0;  ///< up and down, with the lead of RotorLead
  double rate_per_s = 0.0;
  double rate_integral_per_s2 = 0.0;
  double attitude_per_s = 0.0;
  double attitude_lag_s = 0.0;  ///< of the tilt behind its set-point, as one lag
  double velocity_per_s = 0.0;
  double acceleration_gain = 0.0;         ///< on what the acceleration is off by
  double push_lag_s = 0.0;                ///< with which a push from outside is noticed
  double velocity_bandwidth_per_s = 0.0;  ///< of the answer to a set-point
  double climb_per_s = 0.0;
  double climb_integral_per_s2 = 0.0;
  double climb_bandwidth_per_s = 0.0;
  double yaw_acceleration_rad_s2 = 0.0;  ///< what leaves room for roll and pitch
  double drag_per_s = 0.0;               ///< deceleration over speed in hover, from the rotors
  double yaw_drag_per_s = 0.0;           ///< the same of the yaw rate

  explicit Gains(const AirframeParameters& airframe);
};

}  // namespace lineservo::vehicle
