#include "vehicle/autopilot/reference_axis.h"

#include <algorithm>

namespace lineservo::vehicle {

// τ s² + (1 + k₂) s + k₁ = τ (s² + 2 ζ ω s + ω²)
ReferenceAxis::ReferenceAxis(const Answer& answer, double period_s)
    : period_s_(period_s),
      lag_s_(answer.lag_s),
      k1_(answer.bandwidth_per_s * answer.bandwidth_per_s * answer.lag_s),
      k2_(2.0 * answer.damping * answer.bandwidth_per_s * answer.lag_s - 1.0),
      max_acceleration_m_s2_(answer.max_acceleration_m_s2) {}

double ReferenceAxis::step(double target_m_s) {
  const double command = std::clamp(k1_ * (target_m_s - velocity_m_s_) - k2_ * acceleration_m_s2_,
                                    -max_acceleration_m_s2_, max_acceleration_m_s2_);
  // The lag is stepped implicitly: stable for lags shorter than the period.
  acceleration_m_s2_ = (lag_s_ * acceleration_m_s2_ + period_s_ * command) / (lag_s_ + period_s_);
  velocity_m_s_ += period_s_ * acceleration_m_s2_;
  return command;
}

void ReferenceAxis::reset(double velocity_m_s) {
  velocity_m_s_ = velocity_m_s;
  acceleration_m_s2_ = 0.0;
}

}  // namespace lineservo::vehicle
