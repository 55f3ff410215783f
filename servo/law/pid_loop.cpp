#include "servo/law/pid_loop.h"

#include <algorithm>
#include <cmath>

namespace lineservo::servo {

double PidLoop::update(double error, double dt_s, const PidGains& gains, double limit) {
  const bool has_step = has_previous_ && dt_s > 0.0;
  if (has_step) derivative_ = (error - previous_) / dt_s;
  previous_ = error;
  has_previous_ = true;
  const double grown = has_step ? integral_ + error * dt_s : integral_;
  const auto output = [&](double integral) {
    return gains.kp * error + gains.ki * integral + gains.kd * derivative_;
  };
  if (std::abs(output(grown)) < limit || error * integral_ < 0.0) integral_ = grown;
  return std::clamp(output(integral_), -limit, limit);
}

}  // namespace lineservo::servo
