#pragma once

#include "vehicle/attitude.h"
#include "vehicle/body_state.h"
#include "vehicle/sensors/gauss_markov.h"
#include "vehicle/sensors/sensor_parameters.h"
#include "vehicle/sensors/sensor_readings.h"

namespace lineservo::vehicle {

/// The inertial unit with its levelling, the optical flow and the range finder. Each source of noise has its
/// own stream of the flight's seed, so that switching one off leaves the others as they were.
class Sensors {
 public:
  Sensors(const SensorParameters& parameters, std::uint64_t seed, const BodyState& start);

  /// To be called every kInertialPeriod, first at t = 0.
  SensorReadings sample(Time t, const BodyState& truth);

 private:
  Eigen::Vector3d specific_force_B(const BodyState& truth);
  void read_inertial(const BodyState& truth, SensorReadings& readings);
  void read_attitude(const BodyState& truth, SensorReadings& readings);
  Eigen::Vector2d read_flow(Time t, const BodyState& truth);
  double read_range(const BodyState& truth);

  SensorParameters parameters_;
  Random gyro_noise_, accelerometer_noise_, attitude_noise_, flow_noise_, flow_bias_noise_, range_noise_;
  Eigen::Vector3d gyro_bias_B_, accelerometer_bias_B_;
  Eigen::Vector2d tilt_offset_rad_;  // of roll and pitch
  Eigen::Vector2d flow_bias_start_m_s_;
  GaussMarkov roll_error_, pitch_error_, flow_bias_x_, flow_bias_y_;
  BodyState last_;
};

}  // namespace lineservo::vehicle
