#include "vehicle/estimator/estimator.h"

#include <algorithm>
#include <cmath>

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {
namespace {

constexpr double kPeriod_s = seconds(kInertialPeriod);
// A filter that trusts a sensor without limit cannot follow what it does not model: least errors to assume.
constexpr double kLeastFlowSigma_m_s = 2e-3;
constexpr double kLeastRangeSigma_m = 1e-3;
constexpr double kLeastAcceleration_m_s2 = 5e-3;

constexpr double kRangeGate_sigmas = 6.0, kLeastRangeGate_m = 0.1, kMostRangeGate_m = 0.3;

double white_density(double sigma_at_least) {
  return sigma_at_least * sigma_at_least * kPeriod_s;
}

double acceleration_density(const SensorParameters& p) {
  return white_density(std::max(p.accelerometer_sigma_m_s2, kLeastAcceleration_m_s2));
}

// The correction c of the horizontal acceleration stands for g times the tilt tracker's error and the
// accelerometer's bias. It is driven by the gyro's noise (g σ_gyro √T) and drifts with the gyro's bias.
ChainFilter velocity_filter(const SensorParameters& p) {
  ChainFilter::Noise noise;
  const double tilt_walk = kGravity_m_s2 * std::max(p.gyro_sigma_rad_s, 1e-4);
  noise.drive << acceleration_density(p), white_density(tilt_walk), 3e-7;
  noise.measurement_sigma = std::max(p.flow_sigma_m_s, kLeastFlowSigma_m_s);
  const double start_c = std::hypot(kGravity_m_s2 * p.attitude_sigma_rad, p.accelerometer_bias_m_s2);
  const double start_drift = kGravity_m_s2 * p.gyro_bias_rad_s;
  return {kPeriod_s, noise, Eigen::Vector3d::Zero(), {0.01, start_c + 0.005, start_drift + 1e-4}};
}

ChainFilter height_filter(const SensorParameters& p, double start_height_m) {
  ChainFilter::Noise noise;
  noise.drive << 1e-8, acceleration_density(p), 1e-6;
  noise.measurement_sigma = std::max(p.range_sigma_m, kLeastRangeSigma_m);
  const double start_bias = std::max(p.accelerometer_bias_m_s2, 0.01);
  return {kPeriod_s, noise, {start_height_m, 0.0, 0.0}, {noise.measurement_sigma, 0.01, start_bias}};
}

double height_from_range(double range_m, double roll_rad, double pitch_rad) {
  return range_m * std::cos(roll_rad) * std::cos(pitch_rad);
}

double first_height_m(const SensorReadings& first) {
  return height_from_range(first.range_m.value_or(0.0), first.roll_rad, first.pitch_rad);
}

}  // namespace

Estimator::Estimator(const SensorParameters& parameters, const SensorReadings& first)
    : Estimator(parameters, ReadingGuard(first), ReadingGuard(first).checked(first, 0.0, 0.0)) {}

Estimator::Estimator(const SensorParameters& parameters, const ReadingGuard& guard,
                     const SensorReadings& first)
    : guard_(guard),
      tilt_(first.roll_rad, first.pitch_rad),
      v_x_(velocity_filter(parameters)),
      v_y_(velocity_filter(parameters)),
      height_(height_filter(parameters, first_height_m(first))),
      last_gyro_B_(first.gyro_B_rad_s) {
  publish(first, Eigen::Vector3d::Zero());
}

void Estimator::update(const SensorReadings& heard) {
  const SensorReadings readings = guard_.checked(heard, tilt_.roll_rad(), tilt_.pitch_rad());
  // The gyro is sampled at the ends of the period: the trapezium rule for what it turned.
  const Eigen::Vector3d w_B = 0.5 * (last_gyro_B_ + readings.gyro_B_rad_s);
  last_gyro_B_ = readings.gyro_B_rad_s;
  const double old_roll = tilt_.roll_rad(), old_pitch = tilt_.pitch_rad();
  tilt_.step(w_B, readings.roll_rad, readings.pitch_rad, kPeriod_s);
  const double roll = 0.5 * (old_roll + tilt_.roll_rad()), pitch = 0.5 * (old_pitch + tilt_.pitch_rad());
  const Eigen::Vector3d a_H =
      tilt_q_HB(roll, pitch) * readings.specific_force_B_m_s2 - kGravity_m_s2 * Eigen::Vector3d::UnitZ();
  const double yaw_step_rad = kPeriod_s * euler_rates(w_B, roll, pitch).yaw_rad;
  estimate_.yaw_rad += yaw_step_rad;
  predict(a_H, yaw_step_rad);
  correct(readings);
  publish(readings, a_H);
}

void Estimator::predict(const Eigen::Vector3d& a_H, double yaw_step_rad) {
  v_x_.predict({kPeriod_s * a_H.x(), 0.0, 0.0});
  v_y_.predict({kPeriod_s * a_H.y(), 0.0, 0.0});
  turn_horizontal_axes(yaw_step_rad);
  height_.predict({0.5 * kPeriod_s * kPeriod_s * a_H.z(), kPeriod_s * a_H.z(), 0.0});
}

// The velocity stays in the floor's frame while H turns. Of the acceleration's correction, the part from the
// tilt stays as well, the part from the accelerometer turns with the body: which is which is not known, so
// the correction is kept and doubted by what it may have turned.
void Estimator::turn_horizontal_axes(double yaw_step_rad) {
  const Eigen::Vector2d v_H = turned({v_x_.state()[0], v_y_.state()[0]}, -yaw_step_rad);
  v_x_.set_state(0, v_H.x());
  v_y_.set_state(0, v_H.y());
  const double c2 = v_x_.state()[1] * v_x_.state()[1] + v_y_.state()[1] * v_y_.state()[1];
  const double doubt = 0.5 * c2 * std::abs(yaw_step_rad);
  v_x_.doubt(1, doubt);
  v_y_.doubt(1, doubt);
}

void Estimator::correct(const SensorReadings& readings) {
  if (readings.flow_v_H_m_s) {
    v_x_.measure(readings.flow_v_H_m_s->x());
    v_y_.measure(readings.flow_v_H_m_s->y());
    estimate_.flow_heard = readings.stamp;
  }
  if (readings.range_m) {
    hear_range(height_from_range(*readings.range_m, readings.roll_rad, readings.pitch_rad), readings.stamp);
  }
}

// What is further off than the filter can be is no height. Among wild ranges one is near it now and then:
// after one that is not, several in a row must be.
void Estimator::hear_range(double height_m, Time stamp) {
  const double off_m = std::abs(height_m - height_.state()[0]);
  const double sigma_m = std::sqrt(height_.covariance()(0, 0) + height_.measurement_variance());
  const double gate_m = std::clamp(kRangeGate_sigmas * sigma_m, kLeastRangeGate_m, kMostRangeGate_m);
  ranges_agreed_ = off_m < gate_m ? std::min(ranges_agreed_ + 1, kAgreeingRanges) : 0;
  if (ranges_agreed_ < kAgreeingRanges) return;
  height_.measure(height_m);
  estimate_.range_heard = stamp;
}

void Estimator::publish(const SensorReadings& readings, const Eigen::Vector3d& a_H) {
  estimate_.stamp = readings.stamp;
  estimate_.roll_rad = readings.roll_rad;
  estimate_.pitch_rad = readings.pitch_rad;
  estimate_.w_B_rad_s = readings.gyro_B_rad_s;
  estimate_.v_H_m_s << v_x_.state()[0], v_y_.state()[0], height_.state()[1];
  estimate_.a_H_m_s2 << a_H.x() + v_x_.state()[1], a_H.y() + v_y_.state()[1];
  estimate_.height_m = height_.state()[0];
}

}  // namespace lineservo::vehicle
