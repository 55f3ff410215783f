#include "vehicle/estimator/reading_guard.h"

#include <cmath>

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {
namespace {

// Full scale of such sensors, and the most that a body rate changes within an inertial period.
constexpr double kMostRate_rad_s = 35.0, kMostForce_m_s2 = 160.0, kMostSpeed_m_s = 20.0, kMostRange_m = 40.0;
constexpr double kMostRateStep_rad_s = 2.0;
/// So many in a row that go on from each other are no outliers any more: the body itself does that.
constexpr int kGoingOn = 4;
/// By more the specific force changes where the body moves; less is the settling of one that stands.
constexpr double kStill_m_s2 = 0.02;
/// At 50 Hz: 0.2 s.
constexpr int kFrozenAfter = 10;

bool is_possible(const Eigen::Vector3d& v, double most) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= most;
}

}  // namespace

ReadingGuard::ReadingGuard(const SensorReadings& first) : last_(first), gyro_heard_(first.gyro_B_rad_s) {
  if (!is_possible(first.gyro_B_rad_s, kMostRate_rad_s)) last_.gyro_B_rad_s.setZero();
  if (!is_possible(first.specific_force_B_m_s2, kMostForce_m_s2))
    last_.specific_force_B_m_s2 = kGravity_m_s2 * Eigen::Vector3d::UnitZ();
}

SensorReadings ReadingGuard::checked(SensorReadings readings, double roll_rad, double pitch_rad) {
  check_range(readings);  // looks at whether the body moves
  check_gyro(readings);
  check_force(readings);
  if (!std::isfinite(readings.roll_rad) || !std::isfinite(readings.pitch_rad)) {
    readings.roll_rad = roll_rad;
    readings.pitch_rad = pitch_rad;
  }
  if (readings.flow_v_H_m_s && !(readings.flow_v_H_m_s->norm() <= kMostSpeed_m_s))
    readings.flow_v_H_m_s.reset();
  return readings;
}

// Outliers that come in a row are no motion either: they do not go on from each other, and the last of them
// would stand for the body's rate until the next good ones were believed.
void ReadingGuard::check_gyro(SensorReadings& readings) {
  Eigen::Vector3d& gyro = readings.gyro_B_rad_s;
  const bool goes_on = is_possible(gyro - gyro_heard_, kMostRateStep_rad_s);
  gyro_heard_ = gyro;
  gyro_going_on_ = goes_on ? gyro_going_on_ + 1 : 0;
  const bool jumps = !is_possible(gyro - last_.gyro_B_rad_s, kMostRateStep_rad_s);
  if (is_possible(gyro, kMostRate_rad_s) && (!jumps || gyro_going_on_ >= kGoingOn)) {
    last_.gyro_B_rad_s = gyro;
  } else {
    gyro = last_.gyro_B_rad_s;
  }
}

void ReadingGuard::check_force(SensorReadings& readings) {
  Eigen::Vector3d& force = readings.specific_force_B_m_s2;
  if (is_possible(force, kMostForce_m_s2)) {
    last_.specific_force_B_m_s2 = force;
  } else {
    force = last_.specific_force_B_m_s2;
  }
}

void ReadingGuard::check_range(SensorReadings& readings) {
  if (!readings.range_m) return;
  const bool repeated = readings.range_m == last_.range_m;
  const bool moves =
      !is_possible(readings.specific_force_B_m_s2 - last_.specific_force_B_m_s2, kStill_m_s2);
  range_repeated_ = repeated && moves ? range_repeated_ + 1 : 0;
  last_.range_m = readings.range_m;
  const bool possible = *readings.range_m >= 0.0 && *readings.range_m <= kMostRange_m;
  if (!possible || range_repeated_ >= kFrozenAfter) readings.range_m.reset();
}

}  // namespace lineservo::vehicle
