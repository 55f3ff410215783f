#pragma once

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {

/// First-order lag of the rotor speeds behind their command, faster up than down, discretised exactly for a
/// command that holds over the step: ω(t + T) = ω_c + (ω(t) − ω_c) e^(−T/τ).
class Motors {
 public:
  Motors(const AirframeParameters& airframe, double step_s);

  /// Commands are brought into [0, max rotor speed].
  void step(const PerRotor& commanded_rad_s);

  /// At the end of the last step, and in its middle.
  const PerRotor& speeds_rad_s() const { return speeds_; }
  const PerRotor& mid_step_speeds_rad_s() const { return mid_step_speeds_; }

 private:
  double max_speed_;
  double half_decay_up_, half_decay_down_;  // e^(−T/2τ)
  PerRotor speeds_ = PerRotor::Zero();
  PerRotor mid_step_speeds_ = PerRotor::Zero();
};

}  // namespace lineservo::vehicle
