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
  VelocityCommand command{goal.speed_m_s, 0.0, height_rate(observation.estimate.height_m, goal.height_m),
                          0.0};
  const auto& centroid = observation.features.centroid_px;
  if (centroid && std::isfinite(centroid->x)) {
    // c_x grows to the right of the image, the vehicle's left is positive.
    const double offset_px = centroid->x - options_.half_width_px;
    if (observation.features.code.smoothed == JunctionCode::straight) {
      command.left_m_s = -output(offset_px / options_.half_width_px);  // e_n = (c_x − c_0) / c_0 (eq. 3)
    }
    if (goal.curved) command.yaw_rate_rad_s = yaw_rate_rad_s(offset_px, observation);
  }
  captured_ = observation.captured;
  return command;
}

// ψ = atan(Δx / f) (eq. 6) when |Δx| > Γ / 2h; to the right of the image is clockwise.
double PidLaw::yaw_rate_rad_s(double offset_px, const Observation& observation) const {
  const double period_s = captured_ ? seconds(observation.captured - *captured_) : 0.0;
  const double threshold_px = options_.yaw_gamma_px_m / (2.0 * observation.estimate.height_m);
  if (period_s <= 0.0 || std::abs(offset_px) <= threshold_px) return 0.0;
  const double clipped_px = std::clamp(offset_px, -options_.yaw_clip_px, options_.yaw_clip_px);
  const double psi_rad = std::atan(clipped_px / options_.yaw_focal_px);
  return std::clamp(-psi_rad / period_s, -options_.yaw_rate_limit_rad_s, options_.yaw_rate_limit_rad_s);
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
