#include "servo/law/pid_law.h"

#include <algorithm>
#include <cmath>

#include "servo/law/height_rate.h"

namespace lineservo::servo {

using features::JunctionCode;

void PidLaw::reset() {
  *this = PidLaw(options_);
}

Command PidLaw::follow(const Observation& observation, const FollowGoal& goal) {
  VelocityCommand command{goal.speed_m_s, 0.0, height_rate(observation.height_m, goal.height_m), 0.0};
  const auto& centroid = observation.features.centroid_px;
  if (centroid && std::isfinite(centroid->x) &&
      observation.features.code.smoothed == JunctionCode::straight) {
    // e_n = (c_x − c_0) / c_0 (eq. 3); c_x grows to the right of the image, the vehicle's left is positive.
    command.left_m_s = -output((centroid->x - options_.half_width_px) / options_.half_width_px);
  }
  return command;
}

double PidLaw::output(double normalized_error) {
  const bool at_rest = std::abs(normalized_error) < options_.dead_zone;
  const double error = at_rest ? 0.0 : normalized_error;
  integral_ =
      at_rest ? 0.0 : std::clamp(integral_ + error, -options_.integral_limit, options_.integral_limit);
  const double derivative = error - previous_error_;
  previous_error_ = error;
  return options_.kp * error + options_.ki * integral_ + options_.kd * derivative;
}

}  // namespace lineservo::servo
