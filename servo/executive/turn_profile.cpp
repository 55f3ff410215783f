#include "servo/executive/turn_profile.h"

#include <algorithm>
#include <cmath>

namespace lineservo::servo {

double turn_rate(double remaining_rad, const TurnOptions& options) {
  const double angle_rad = std::abs(remaining_rad);
  const double rate =
      std::min({options.gain_per_s * angle_rad, std::sqrt(2.0 * options.acceleration_rad_s2 * angle_rad),
                options.rate_limit_rad_s});
  return std::copysign(rate, remaining_rad);
}

double turn_time_s(double turn_rad, const TurnOptions& options) {
  const double rate = options.rate_limit_rad_s;
  return std::abs(turn_rad) / rate + 0.5 * rate / options.acceleration_rad_s2;
}

}  // namespace lineservo::servo
