#pragma once

#include <cmath>
#include <numbers>

namespace lineservo::features {

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) {
  return degrees * kPi / 180.0;
}
constexpr double degrees(double radians) {
  return radians * 180.0 / kPi;
}

/// The angle brought into (−π, π].
inline double wrap_angle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

/// Between two lines without a direction, in [0, π/2].
inline double axis_difference(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, kPi));
}

}  // namespace lineservo::features
