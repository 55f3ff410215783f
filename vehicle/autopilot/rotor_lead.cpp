#include "vehicle/autopilot/rotor_lead.h"

#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {

RotorLead::RotorLead(const AirframeParameters& airframe, double wanted_lag_s, double period_s)
    : thrust_coefficient_N_s2_(airframe.thrust_coefficient_N_s2),
      max_speed_rad_s_(airframe.max_rotor_speed_rad_s),
      rise_wanted_(1.0 - std::exp(-period_s / wanted_lag_s)),
      rise_up_(1.0 - std::exp(-period_s / airframe.motor_lag_up_s)),
      rise_down_(1.0 - std::exp(-period_s / airframe.motor_lag_down_s)) {}

// The model goes ω ← ω + r (ω_c − ω). Wanted is ω + r_w (ω_w − ω), so ω_c = ω + (ω_w − ω) r_w / r.
PerRotor RotorLead::command_rad_s(const PerRotor& wanted_thrusts_N) {
  PerRotor command;
  for (int i = 0; i < kRotors; ++i) {
    const double wanted = std::sqrt(std::max(wanted_thrusts_N[i], 0.0) / thrust_coefficient_N_s2_);
    const double rise = wanted > model_rad_s_[i] ? rise_up_ : rise_down_;
    const double ahead = model_rad_s_[i] + (wanted - model_rad_s_[i]) * rise_wanted_ / rise;
    command[i] = std::clamp(ahead, 0.0, max_speed_rad_s_);
    model_rad_s_[i] += rise * (command[i] - model_rad_s_[i]);
  }
  return command;
}

}  // namespace lineservo::vehicle
