#include "vehicle/body/motors.h"

#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {

Motors::Motors(const AirframeParameters& airframe, double step_s)
    : max_speed_(airframe.max_rotor_speed_rad_s),
      half_decay_up_(std::exp(-0.5 * step_s / airframe.motor_lag_up_s)),
      half_decay_down_(std::exp(-0.5 * step_s / airframe.motor_lag_down_s)) {}

void Motors::step(const PerRotor& commanded_rad_s) {
  for (int i = 0; i < kRotors; ++i) {
    const double target = std::clamp(commanded_rad_s[i], 0.0, max_speed_);
    const double half_decay = target > speeds_[i] ? half_decay_up_ : half_decay_down_;
    mid_step_speeds_[i] = target + (speeds_[i] - target) * half_decay;
    speeds_[i] = target + (mid_step_speeds_[i] - target) * half_decay;
  }
}

}  // namespace lineservo::vehicle
