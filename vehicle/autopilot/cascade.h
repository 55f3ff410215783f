#pragma once

#include "vehicle/autopilot/attitude_controller.h"
#include "vehicle/autopilot/mixer.h"
#include "vehicle/autopilot/rate_controller.h"
#include "vehicle/autopilot/rotor_lead.h"
#include "vehicle/autopilot/velocity_controller.h"
#include "vehicle/setpoint.h"

namespace lineservo::vehicle {

/// The control loops, from a set-point within the limits to rotor commands: velocity → tilt → body rates →
/// mixer → rotor lead. It has no modes.
class Cascade {
 public:
  Cascade(const AirframeParameters& airframe, const AutopilotOptions& options, double period_s);

  PerRotor fly(const VelocitySetpoint& setpoint, const Estimate& estimate);
  PerRotor fly(const AttitudeSetpoint& setpoint, const Estimate& estimate);
  /// On the ground with stopped motors: nothing is learnt there.
  void rest();

 private:
  bool on_ground(const Estimate& estimate) const;
  void begin_velocity_control(const Estimate& estimate);
  PerRotor stabilise(const TiltTarget& tilt, double yaw_rate_set_rad_s, double climb_rate_m_s,
                     const Estimate& estimate);
  void slew_yaw_rate(double yaw_rate_set_rad_s);
  void learn(const ThrustAndTorque& wanted, const ThrustAndTorque& got, const Estimate& estimate);

  double period_s_, mass_kg_, gear_height_m_;
  SafetyLimits limits_;
  Gains gains_;
  HorizontalController horizontal_;
  VerticalController vertical_;
  RateController rates_;
  Mixer mixer_;
  RotorLead lead_;
  bool velocity_controlled_ = false;
  double yaw_rate_rad_s_ = 0.0, yaw_acceleration_rad_s2_ = 0.0;
};

}  // namespace lineservo::vehicle
