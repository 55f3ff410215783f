#pragma once

#include <numbers>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// How often each sensor answers. The autopilot runs with the inertial unit.
inline constexpr Time kInertialPeriod = std::chrono::milliseconds(5);
inline constexpr Time kFlowPeriod = std::chrono::milliseconds(50);
inline constexpr Time kRangePeriod = std::chrono::milliseconds(20);

/// Errors of the sensors. Biases are standard deviations too: each flight draws its own from its seed.
/// The defaults are the conditions `paper`.
struct SensorParameters {
  static constexpr double kDegree = std::numbers::pi / 180.0;

  double gyro_sigma_rad_s = 0.1 * kDegree;
  double gyro_bias_rad_s = 0.05 * kDegree;
  double accelerometer_sigma_m_s2 = 0.05;
  double accelerometer_bias_m_s2 = 0.05;
  /// Of roll and pitch: first-order Gauss–Markov. Levelled by the accelerometer, so its bias dominates,
  /// slowly varying.
  double attitude_sigma_rad = 0.2 * kDegree;
  double attitude_correlation_s = 10.0;
  /// Added to the above in a direction of the flight's own: a badly levelled autopilot.
  double tilt_offset_rad = 0.0;
  double flow_sigma_m_s = 0.03;
  double flow_bias_m_s = 0.01;  ///< first-order Gauss–Markov
  double flow_bias_correlation_s = 60.0;
  /// Added to the above: what it is off by at power-on, in a direction of the flight's own, and dies away
  /// with the same time constant.
  double flow_bias_start_m_s = 0.0;
  double range_sigma_m = 0.005;

  /// Every error zero.
  static SensorParameters ideal();
  /// Throws one std::invalid_argument that lists every fault.
  void validate() const;
};

}  // namespace lineservo::vehicle
