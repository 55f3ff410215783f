#pragma once

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {

/// Rotor commands that make up for the motors' different lags: from a model of the motors it commands beyond
/// the wanted speed by as much as brings the rotor there with one lag, up and down alike.
class RotorLead {
 public:
  RotorLead(const AirframeParameters& airframe, double wanted_lag_s, double period_s);

  PerRotor command_rad_s(const PerRotor& wanted_thrusts_N);
  /// The motors stand still.
  void reset() { model_rad_s_.setZero(); }

 private:
  double thrust_coefficient_N_s2_, max_speed_rad_s_;
  double rise_wanted_, rise_up_, rise_down_;  // 1 − e^(−T/τ)
  PerRotor model_rad_s_ = PerRotor::Zero();
};

}  // namespace lineservo::vehicle
