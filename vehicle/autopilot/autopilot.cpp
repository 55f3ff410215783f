#include "vehicle/autopilot/autopilot.h"

#include <cmath>

#include "vehicle/autopilot/limits.h"
#include "vehicle/sensors/sensor_parameters.h"

namespace lineservo::vehicle {
namespace {

constexpr double kGroundClearance_m = 0.03;
constexpr double kStandingSpeed_m_s = 0.1;
constexpr Time kSettles = std::chrono::milliseconds(300);
/// A height that was not measured for so long does not tell the ground.
constexpr Time kHeightStale = std::chrono::milliseconds(500);
constexpr double kCarried = 0.75;  // of the weight: the integral takes off no more than a third
/// From this far above the gear the descent is slow.
constexpr double kLastBit_m = 0.2;

const AirframeParameters& checked(const AirframeParameters& airframe) {
  airframe.validate();
  return airframe;
}

const AutopilotOptions& checked(const AutopilotOptions& options) {
  options.validate();
  return options;
}

}  // namespace

Autopilot::Autopilot(const AirframeParameters& airframe, const AutopilotOptions& options)
    : options_(checked(options)),
      gear_height_m_(checked(airframe).gear_height_m),
      hover_speed2_rad2_s2_(airframe.weight_N() / airframe.thrust_coefficient_N_s2),
      cascade_(airframe, options, seconds(kInertialPeriod)) {}

void Autopilot::command(const Setpoint& setpoint, Time stamp, Time holds_for, Time now) {
  commands_.offer(setpoint, stamp, holds_for, now);
}

PerRotor Autopilot::update(Time now, const Estimate& estimate) {
  watch_ground(now, estimate);
  enter(next_mode(mode_, situation(now, estimate)), now, estimate);
  if (!motors_run(mode_)) {
    cascade_.rest();
    blind_.reset();
    return PerRotor::Zero();
  }
  blind_.travel(estimate, seconds(kInertialPeriod));
  const PerRotor rotors_rad_s = drive(now, estimate);
  speed2_rad2_s2_ = rotors_rad_s.squaredNorm();
  return rotors_rad_s;
}

PerRotor Autopilot::drive(Time now, const Estimate& estimate) {
  if (mode_ == AutopilotMode::tracking) return track(*commands_.live(now), estimate);
  return mode_ == AutopilotMode::braking ? brake(estimate) : land(estimate);
}

Situation Autopilot::situation(Time now, const Estimate& estimate) const {
  const Setpoint* command = commands_.live(now);
  Situation s;
  s.command_live = command != nullptr;
  s.wants_up = command != nullptr && wants_up(*command);
  s.land_requested = commands_.land_requested();
  s.estimate_fresh = now - estimate.stamp <= kStale;
  s.blind = blind_.travelled_m() > options_.limits.max_blind_travel_m;
  s.settled_on_ground = now - off_ground_at_ >= kSettles;
  s.in_mode_for = now - mode_since_;
  return s;
}

bool Autopilot::wants_up(const Setpoint& setpoint) const {
  if (const auto* velocity = std::get_if<VelocitySetpoint>(&setpoint)) return velocity->v_H_m_s.z() > 0.0;
  const auto* attitude = std::get_if<AttitudeSetpoint>(&setpoint);
  return attitude != nullptr && attitude->height_m > gear_height_m_ + kGroundClearance_m;
}

void Autopilot::watch_ground(Time now, const Estimate& estimate) {
  // Only a vehicle that lands counts as standing: one that takes off needs its time.
  if (!stands(now, estimate) || mode_ != AutopilotMode::landing) off_ground_at_ = now;
}

// By the height; where no sensor tells it, by the floor's carrying what the rotors, told to go down, do not.
bool Autopilot::stands(Time now, const Estimate& estimate) const {
  if (now - estimate.range_heard > kHeightStale) return speed2_rad2_s2_ < kCarried * hover_speed2_rad2_s2_;
  const bool low = estimate.height_m < gear_height_m_ + kGroundClearance_m;
  return low && std::abs(estimate.v_H_m_s.z()) < kStandingSpeed_m_s;
}

void Autopilot::enter(AutopilotMode mode, Time now, const Estimate& estimate) {
  if (mode == mode_) return;
  mode_ = mode;
  mode_since_ = now;
  hold_height_m_ = estimate.height_m;
  if (mode == AutopilotMode::landed) commands_.clear();
}

PerRotor Autopilot::track(const Setpoint& setpoint, const Estimate& estimate) {
  if (const auto* velocity = std::get_if<VelocitySetpoint>(&setpoint)) {
    return cascade_.fly(limited(*velocity, estimate, options_.limits), estimate);
  }
  return cascade_.fly(limited(std::get<AttitudeSetpoint>(setpoint), options_.limits), estimate);
}

PerRotor Autopilot::brake(const Estimate& estimate) {
  VelocitySetpoint stop;
  stop.v_H_m_s.z() = climb_rate_to(hold_height_m_, estimate, options_.limits);
  return cascade_.fly(stop, estimate);
}

PerRotor Autopilot::land(const Estimate& estimate) {
  const bool last_bit = estimate.height_m < gear_height_m_ + kLastBit_m;
  VelocitySetpoint down;
  down.v_H_m_s.z() = -(last_bit ? options_.touchdown_speed_m_s : options_.descent_speed_m_s);
  return cascade_.fly(limited(down, estimate, options_.limits), estimate);
}

}  // namespace lineservo::vehicle
