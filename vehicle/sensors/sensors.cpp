#include "vehicle/sensors/sensors.h"

#include <algorithm>
#include <cmath>

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {
namespace {

/// The streams of the flight's seed that the sensors use.
enum Stream : std::uint64_t {
  kBiases = 101,
  kGyro,
  kAccelerometer,
  kAttitude,
  kFlow,
  kFlowBias,
  kRange,
};

Eigen::Vector3d normal_vector(Random& random, double sigma) {
  const double x = random.normal(sigma), y = random.normal(sigma);
  return {x, y, random.normal(sigma)};
}

Eigen::Vector2d of_any_direction(Random& random, double length) {
  const double direction_rad = random.uniform(0.0, 2.0 * std::numbers::pi);
  return {length * std::cos(direction_rad), length * std::sin(direction_rad)};
}

}  // namespace

Sensors::Sensors(const SensorParameters& p, std::uint64_t seed, const BodyState& start)
    : parameters_(p),
      gyro_noise_(seed, kGyro),
      accelerometer_noise_(seed, kAccelerometer),
      attitude_noise_(seed, kAttitude),
      flow_noise_(seed, kFlow),
      flow_bias_noise_(seed, kFlowBias),
      range_noise_(seed, kRange),
      roll_error_(p.attitude_sigma_rad, p.attitude_correlation_s, seconds(kInertialPeriod), attitude_noise_),
      pitch_error_(p.attitude_sigma_rad, p.attitude_correlation_s, seconds(kInertialPeriod), attitude_noise_),
      flow_bias_x_(p.flow_bias_m_s, p.flow_bias_correlation_s, seconds(kFlowPeriod), flow_bias_noise_),
      flow_bias_y_(p.flow_bias_m_s, p.flow_bias_correlation_s, seconds(kFlowPeriod), flow_bias_noise_),
      last_(start) {
  parameters_.validate();
  Random biases(seed, kBiases);
  gyro_bias_B_ = normal_vector(biases, p.gyro_bias_rad_s);
  accelerometer_bias_B_ = normal_vector(biases, p.accelerometer_bias_m_s2);
  tilt_offset_rad_ = of_any_direction(biases, p.tilt_offset_rad);
  flow_bias_start_m_s_ = of_any_direction(biases, p.flow_bias_start_m_s);
}

SensorReadings Sensors::sample(Time t, const BodyState& truth) {
  SensorReadings readings;
  readings.stamp = t;
  read_inertial(truth, readings);
  read_attitude(truth, readings);
  if (t % kFlowPeriod == Time(0)) readings.flow_v_H_m_s = read_flow(t, truth);
  if (t % kRangePeriod == Time(0)) readings.range_m = read_range(truth);
  last_ = truth;
  return readings;
}

// f_B = R_BW (v̇_W − g_W), the mean over the last period: what is left after the unit's anti-alias filter. The
// attitude is that of the period's middle.
Eigen::Vector3d Sensors::specific_force_B(const BodyState& truth) {
  const Eigen::Vector3d a_W = (truth.v_W - last_.v_W) / seconds(kInertialPeriod);
  Eigen::Quaterniond q_WB = truth.q_WB;
  if (q_WB.coeffs().dot(last_.q_WB.coeffs()) < 0.0) q_WB.coeffs() = -q_WB.coeffs();
  q_WB.coeffs() += last_.q_WB.coeffs();
  q_WB.normalize();
  return q_WB.conjugate() * (a_W + kGravity_m_s2 * Eigen::Vector3d::UnitZ());
}

void Sensors::read_inertial(const BodyState& truth, SensorReadings& readings) {
  readings.gyro_B_rad_s = truth.w_B + gyro_bias_B_ + normal_vector(gyro_noise_, parameters_.gyro_sigma_rad_s);
  readings.specific_force_B_m_s2 = specific_force_B(truth) + accelerometer_bias_B_ +
                                   normal_vector(accelerometer_noise_, parameters_.accelerometer_sigma_m_s2);
}

void Sensors::read_attitude(const BodyState& truth, SensorReadings& readings) {
  const RollPitchYaw angles = roll_pitch_yaw(truth.q_WB);
  readings.roll_rad = angles.roll_rad + roll_error_.value() + tilt_offset_rad_.x();
  readings.pitch_rad = angles.pitch_rad + pitch_error_.value() + tilt_offset_rad_.y();
  roll_error_.step(attitude_noise_);
  pitch_error_.step(attitude_noise_);
}

Eigen::Vector2d Sensors::read_flow(Time t, const BodyState& truth) {
  const Eigen::Vector2d v_W = truth.v_W.head<2>();
  Eigen::Vector2d v_H = turned(v_W, -roll_pitch_yaw(truth.q_WB).yaw_rad);
  v_H += Eigen::Vector2d(flow_bias_x_.value(), flow_bias_y_.value());
  v_H += std::exp(-seconds(t) / parameters_.flow_bias_correlation_s) * flow_bias_start_m_s_;
  v_H.x() += flow_noise_.normal(parameters_.flow_sigma_m_s);
  v_H.y() += flow_noise_.normal(parameters_.flow_sigma_m_s);
  flow_bias_x_.step(flow_bias_noise_);
  flow_bias_y_.step(flow_bias_noise_);
  return v_H;
}

// The beam meets the floor at height / cos(tilt).
double Sensors::read_range(const BodyState& truth) {
  const double cosine = std::max(std::cos(tilt_rad(truth.q_WB)), 0.1);
  return truth.p_WB.z() / cosine + range_noise_.normal(parameters_.range_sigma_m);
}

}  // namespace lineservo::vehicle
