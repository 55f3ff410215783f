#include "servo/law/drift_observer.h"

#include <algorithm>
#include <cmath>

namespace lineservo::servo {

void DriftObserver::update(double measured_m, double odometry_step_m, double dt_s) {
  if (!has_position_ || dt_s <= 0.0) {
    position_m_ = measured_m;
    has_position_ = true;
    return;
  }
  const double pole = std::exp(-dt_s / time_constant_s_);
  const double predicted_m = position_m_ + odometry_step_m + drift_m_s_ * dt_s;
  const double residual_m = measured_m - predicted_m;
  position_m_ = predicted_m + (1.0 - pole * pole) * residual_m;
  drift_m_s_ += (1.0 - pole) * (1.0 - pole) * residual_m / dt_s;
  drift_m_s_ = std::clamp(drift_m_s_, -limit_m_s_, limit_m_s_);
}

}  // namespace lineservo::servo
