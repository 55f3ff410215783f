#pragma once

namespace lineservo::servo {

/// How a turn on the spot is flown.
struct TurnOptions {
  double gain_per_s = 2.0;
  double rate_limit_rad_s = 0.6;
  double acceleration_rad_s2 = 1.0;  ///< with which the turn is braked
};

/// Yaw rate for an angle that is left to turn: proportional near the end, √(2·α·|Δ|) before, limited. Same
/// sign as Δ.
double turn_rate(double remaining_rad, const TurnOptions& options);

/// About how long a turn takes, from its beginning at the limit to the end of its braking.
double turn_time_s(double turn_rad, const TurnOptions& options);

}  // namespace lineservo::servo
