#pragma once

#include "vehicle/estimate.h"
#include "vehicle/estimator/chain_filter.h"
#include "vehicle/estimator/reading_guard.h"
#include "vehicle/estimator/tilt_tracker.h"
#include "vehicle/sensors/sensors.h"

namespace lineservo::vehicle {

/// Fuses the sensors, every kInertialPeriod, into what the vehicle believes of itself. The velocity follows
/// the accelerometer and is corrected by the flow; the height follows it and is corrected by the range.
class Estimator {
 public:
  /// From the first readings, taken at rest; level on the floor for what they do not tell.
  Estimator(const SensorParameters& parameters, const SensorReadings& first);

  /// Whatever comes, the estimate stays finite.
  void update(const SensorReadings& readings);
  const Estimate& estimate() const { return estimate_; }

 private:
  Estimator(const SensorParameters& parameters, const ReadingGuard& guard, const SensorReadings& first);
  void predict(const Eigen::Vector3d& a_H_m_s2, double yaw_step_rad);
  void turn_horizontal_axes(double yaw_step_rad);
  void correct(const SensorReadings& readings);
  void hear_range(double height_m, Time stamp);
  void publish(const SensorReadings& readings, const Eigen::Vector3d& a_H_m_s2);

  ReadingGuard guard_;
  TiltTracker tilt_;
  ChainFilter v_x_, v_y_;  // velocity, correction of the acceleration, its drift
  ChainFilter height_;     // height, climb rate, correction of the acceleration
  Eigen::Vector3d last_gyro_B_;
  static constexpr int kAgreeingRanges = 5;
  int ranges_agreed_ = kAgreeingRanges;  ///< in a row, with the height
  Estimate estimate_;
};

}  // namespace lineservo::vehicle
