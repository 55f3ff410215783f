#include "servo/executive/approach.h"

#include <algorithm>
#include <cmath>

namespace lineservo::servo {

double braking_speed(double ahead_m, double end_m_s, const ApproachOptions& options) {
  const double a = options.deceleration_m_s2, aT = a * options.response_s;
  const double speed_m_s = std::sqrt(aT * aT + 2.0 * a * std::max(0.0, ahead_m) + end_m_s * end_m_s) - aT;
  return std::max({speed_m_s, end_m_s, options.speed_m_s});
}

}  // namespace lineservo::servo
