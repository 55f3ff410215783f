#pragma once

#include <algorithm>

namespace lineservo::servo {

/// Climb rate that brings the vehicle to a height: proportional, limited. For phases and laws that have no
/// height task.
inline double height_rate(double height_m, double desired_m, double gain_per_s = 1.5,
                          double limit_m_s = 0.4) {
  return std::clamp(gain_per_s * (desired_m - height_m), -limit_m_s, limit_m_s);
}

}  // namespace lineservo::servo
