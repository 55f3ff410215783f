#include "vehicle/autopilot/cascade.h"

#include <algorithm>
#include <cmath>

#include "vehicle/attitude.h"
#include "vehicle/autopilot/limits.h"

namespace lineservo::vehicle {
namespace {
// Below this height above its gear the vehicle may be standing: it holds level and learns nothing sideways.
constexpr double kClearance_m = 0.03;
}  // namespace

Cascade::Cascade(const AirframeParameters& airframe, const AutopilotOptions& options, double period_s)
    : period_s_(period_s),
      mass_kg_(airframe.mass_kg * options.believed_mass_ratio),
      gear_height_m_(airframe.gear_height_m),
      limits_(options.limits),
      gains_(airframe),
      horizontal_(gains_, options, period_s),
      vertical_(gains_, options, period_s),
      rates_(airframe, gains_, period_s),
      mixer_(airframe),
      lead_(airframe, gains_.rotor_lag_s, period_s) {}

PerRotor Cascade::fly(const VelocitySetpoint& setpoint, const Estimate& estimate) {
  const double yaw_rate = setpoint.yaw_rate_rad_s;
  if (on_ground(estimate)) {
    velocity_controlled_ = false;
    return stabilise({}, 0.0, setpoint.v_H_m_s.z(), estimate);
  }
  begin_velocity_control(estimate);
  const double turn_rate = euler_rates(estimate.w_B_rad_s, estimate.roll_rad, estimate.pitch_rad).yaw_rad;
  const Eigen::Vector2d a_H = horizontal_.acceleration_H(setpoint.v_H_m_s.head<2>(), estimate, turn_rate);
  const TiltTarget tilt = tilt_for({a_H.x(), a_H.y(), kGravity_m_s2});
  return stabilise(tilt, yaw_rate, setpoint.v_H_m_s.z(), estimate);
}

PerRotor Cascade::fly(const AttitudeSetpoint& setpoint, const Estimate& estimate) {
  velocity_controlled_ = false;
  const double climb_rate = climb_rate_to(setpoint.height_m, estimate, limits_);
  if (on_ground(estimate)) return stabilise({}, 0.0, climb_rate, estimate);
  const Eigen::Vector2d a_H = speed_limited(acceleration_of({setpoint.roll_rad, setpoint.pitch_rad}),
                                            estimate, gains_.velocity_per_s, limits_);
  return stabilise(tilt_for({a_H.x(), a_H.y(), kGravity_m_s2}), setpoint.yaw_rate_rad_s, climb_rate,
                   estimate);
}

void Cascade::rest() {
  horizontal_.forget();
  vertical_.forget();
  rates_.forget();
  lead_.reset();
  velocity_controlled_ = false;
  yaw_rate_rad_s_ = yaw_acceleration_rad_s2_ = 0.0;
}

bool Cascade::on_ground(const Estimate& estimate) const {
  return estimate.height_m < gear_height_m_ + kClearance_m;
}

void Cascade::begin_velocity_control(const Estimate& estimate) {
  if (!velocity_controlled_) horizontal_.start_from(estimate.v_H_m_s.head<2>());
  velocity_controlled_ = true;
}

PerRotor Cascade::stabilise(const TiltTarget& tilt, double yaw_rate_set_rad_s, double climb_rate_m_s,
                            const Estimate& estimate) {
  slew_yaw_rate(yaw_rate_set_rad_s);
  const double vertical_m_s2 = kGravity_m_s2 + vertical_.acceleration(climb_rate_m_s, estimate);
  const Eigen::Vector3d w_set_B = body_rates_for(tilt, yaw_rate_rad_s_, estimate, gains_.attitude_per_s);
  const Eigen::Vector3d w_dot_set_B(0.0, 0.0,
                                    yaw_acceleration_rad_s2_ + gains_.yaw_drag_per_s * yaw_rate_rad_s_);
  const ThrustAndTorque wanted{thrust_for(mass_kg_, vertical_m_s2, estimate),
                               rates_.torque_B(w_set_B, w_dot_set_B, estimate.w_B_rad_s)};
  const PerRotor thrusts_N = mixer_.rotor_thrusts_N(wanted);
  learn(wanted, mixer_.result(thrusts_N), estimate);
  return lead_.command_rad_s(thrusts_N);
}

void Cascade::slew_yaw_rate(double yaw_rate_set_rad_s) {
  const double most = gains_.yaw_acceleration_rad_s2 * period_s_;
  const double step = std::clamp(yaw_rate_set_rad_s - yaw_rate_rad_s_, -most, most);
  yaw_rate_rad_s_ += step;
  yaw_acceleration_rad_s2_ = step / period_s_;
}

void Cascade::learn(const ThrustAndTorque& wanted, const ThrustAndTorque& got, const Estimate& estimate) {
  if (on_ground(estimate)) return;
  const Eigen::Array3d missing = (wanted.torque_B_Nm - got.torque_B_Nm).array().abs();
  rates_.integrate((missing < 1e-6).cast<double>());
}

}  // namespace lineservo::vehicle
