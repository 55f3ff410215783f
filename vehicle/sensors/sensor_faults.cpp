#include "vehicle/sensors/sensor_faults.h"

#include <limits>

namespace lineservo::vehicle {
namespace {

constexpr std::uint64_t kWildStream = 120;  // of the flight's seed; sensors.cpp has those before
constexpr double kSpoiltShare = 0.1;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SensorFaults::SensorFaults(const SensorFaultOptions& options, std::uint64_t seed)
    : options_(options), wild_(seed, kWildStream) {}

SensorReadings SensorFaults::spoilt(SensorReadings readings) {
  if (options_.velocity_silent.holds(readings.stamp)) readings.flow_v_H_m_s.reset();
  spoil_range(readings);
  spoil_inertial(readings);
  return readings;
}

void SensorFaults::spoil_range(SensorReadings& readings) {
  if (!readings.range_m) return;
  const Time t = readings.stamp;
  if (options_.range_frozen.holds(t) && last_range_m_) readings.range_m = last_range_m_;
  last_range_m_ = readings.range_m;
  if (options_.range_wild.holds(t)) readings.range_m = wild_.uniform(0.0, kWildRange_m);
  if (options_.range_silent.holds(t)) readings.range_m.reset();
}

void SensorFaults::spoil_inertial(SensorReadings& readings) {
  const Time t = readings.stamp;
  if (options_.attitude_silent.holds(t)) readings.roll_rad = readings.pitch_rad = kNaN;
  if (options_.gyro_wild.holds(t) && wild_.uniform() < kSpoiltShare) {
    for (int axis = 0; axis < 3; ++axis)
      readings.gyro_B_rad_s[axis] += wild_.uniform(-kWildRate_rad_s, kWildRate_rad_s);
  }
  if (options_.not_a_number.holds(t) && wild_.uniform() < kSpoiltShare) {
    readings.gyro_B_rad_s.setConstant(kNaN);
    readings.specific_force_B_m_s2.setConstant(kNaN);
    readings.roll_rad = readings.pitch_rad = kNaN;
    if (readings.flow_v_H_m_s) readings.flow_v_H_m_s->setConstant(kNaN);
    if (readings.range_m) readings.range_m = kNaN;
  }
}

}  // namespace lineservo::vehicle
