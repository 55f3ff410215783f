#pragma once

#include <cstdint>
#include <optional>

#include "vehicle/fault_window.h"
#include "vehicle/random.h"
#include "vehicle/sensors/sensor_readings.h"

namespace lineservo::vehicle {

/// What can go wrong with the sensors, each at a time of its own.
struct SensorFaultOptions {
  FaultWindow range_silent;     ///< no answer
  FaultWindow range_frozen;     ///< the last answer before, over and over
  FaultWindow range_wild;       ///< anything up to kWildRange_m
  FaultWindow velocity_silent;  ///< no optical flow
  FaultWindow attitude_silent;  ///< roll and pitch are not levelled any more
  FaultWindow gyro_wild;        ///< one reading in ten is off by anything up to kWildRate_rad_s
  FaultWindow not_a_number;     ///< one reading in ten of every sensor
};

/// Spoils readings on their way to the estimator.
class SensorFaults {
 public:
  static constexpr double kWildRange_m = 4.0;
  static constexpr double kWildRate_rad_s = 20.0;

  SensorFaults(const SensorFaultOptions& options, std::uint64_t seed);

  SensorReadings spoilt(SensorReadings readings);

 private:
  void spoil_range(SensorReadings& readings);
  void spoil_inertial(SensorReadings& readings);

  SensorFaultOptions options_;
  Random wild_;
  std::optional<double> last_range_m_;
};

}  // namespace lineservo::vehicle
