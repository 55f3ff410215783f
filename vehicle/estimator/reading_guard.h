#pragma once

#include "vehicle/sensors/sensor_readings.h"

namespace lineservo::vehicle {

/// The door of the estimator: what comes through is finite and possible. A flow or range that is not counts
/// as one that did not come, and so does a range that stays the same to the last bit while the body moves. An
/// inertial reading is needed in every period: the last good one stands in, before any that of a body at
/// rest.
class ReadingGuard {
 public:
  explicit ReadingGuard(const SensorReadings& first);

  /// `roll_rad` and `pitch_rad` stand in for a levelled attitude that does not come.
  SensorReadings checked(SensorReadings readings, double roll_rad, double pitch_rad);

 private:
  void check_gyro(SensorReadings& readings);
  void check_force(SensorReadings& readings);
  void check_range(SensorReadings& readings);

  SensorReadings last_;  ///< what was good, of each sensor
  Eigen::Vector3d gyro_heard_;  ///< the last one, good or not
  int gyro_going_on_ = 0;       ///< in a row, each near the one before
  int range_repeated_ = 0;
};

}  // namespace lineservo::vehicle
