#pragma once

#include <chrono>

namespace lineservo::vehicle {

/// Simulated time since the start of the flight. Nothing in this folder but grabber/ reads a clock.
using Time = std::chrono::nanoseconds;

constexpr double seconds(Time t) {
  return static_cast<double>(t.count()) * 1e-9;
}
/// Rounded to the nearest nanosecond.
constexpr Time from_seconds(double t_s) {
  return Time(static_cast<Time::rep>(t_s * 1e9 + (t_s < 0.0 ? -0.5 : 0.5)));
}

}  // namespace lineservo::vehicle
