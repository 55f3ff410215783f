#include "servo/law/ibvs_line_law.h"

#include <algorithm>
#include <cmath>

#include "servo/law/height_rate.h"

namespace lineservo::servo {

using features::LineFeature;

IbvsLineLaw::IbvsLineLaw(const IbvsLineOptions& options)
    : options_(options),
      task_(options.gain, options.interaction),
      drift_(options.drift_time_constant_s, options.drift_limit_m_s) {}

void IbvsLineLaw::reset() {
  last_.reset();
  drift_ = DriftObserver(options_.drift_time_constant_s, options_.drift_limit_m_s);
}

Command IbvsLineLaw::follow(const Observation& observation, const FollowGoal& goal) {
  const std::optional<LineFeature> line = line_now(observation);
  if (!line) return VelocityCommand{0.0, 0.0, height_rate(observation.estimate.height_m, goal.height_m), 0.0};
  const double speed_m_s = safe_speed(*line, observation.estimate.height_m, goal.speed_m_s);
  const double bend_rad_s = line->curvature / observation.estimate.height_m * speed_m_s;  // θ̇ = ω + κ v
  const TaskSolution solution = task_.solve(line->rho, line->theta_rad, observation.estimate.height_m,
                                            goal.height_m, speed_m_s, drift_.drift_m_s(), bend_rad_s);
  return solution.valid ? solution.command : VelocityCommand{};
}

std::optional<LineFeature> IbvsLineLaw::line_now(const Observation& observation) {
  const LineFeature* seen = line_to_follow(observation);
  const bool is_new = !last_ || observation.captured > last_->captured;
  if (seen && is_new) {
    observe_drift(observation, *seen);
    last_ = {*seen, observation.captured, observation.estimate.odometry_at_capture,
             observation.estimate.capture_height_m};
  }
  if (!last_ || seconds(observation.now - last_->captured) > options_.coast_s) return std::nullopt;
  LineFeature line =
      after(between(last_->odometry, observation.estimate.odometry_now), last_->line, last_->height_m);
  // the same metres, seen from the height now
  line.rho *= last_->height_m / observation.estimate.height_m;
  line.curvature *= observation.estimate.height_m / last_->height_m;
  return line;
}

// The vehicle's place to the left of the line is ρh. The odometry's own step across the line is where it
// would have the line of the frame before, less where that was.
void IbvsLineLaw::observe_drift(const Observation& observation, const LineFeature& line) {
  const double left_m = line.rho * observation.estimate.capture_height_m;
  if (!last_) {
    drift_.update(left_m, 0.0, 0.0);
    return;
  }
  const Motion moved = between(last_->odometry, observation.estimate.odometry_at_capture);
  const double step_m = (after(moved, last_->line, last_->height_m).rho - last_->line.rho) * last_->height_m;
  drift_.update(left_m, step_m, seconds(observation.captured - last_->captured));
}

// Slows down as the line nears the border of the view, so that it cannot leave it, and in bends to what the
// vehicle can follow: v²κ ≤ a, vκ ≤ ω.
double IbvsLineLaw::safe_speed(const LineFeature& line, double height_m, double speed_m_s) const {
  const double bend_inv_m = std::abs(line.curvature) / height_m;
  if (bend_inv_m > 0.0) {
    speed_m_s = std::min({speed_m_s, std::sqrt(options_.bend_acceleration_m_s2 / bend_inv_m),
                          options_.bend_yaw_rate_rad_s / bend_inv_m});
  }
  const double offset = std::abs(line.rho) / options_.view_margin;
  const double angle = std::abs(line.theta_rad) / options_.view_angle_rad;
  return speed_m_s * std::clamp(1.0 - offset * offset, 0.0, 1.0) * std::clamp(1.0 - angle * angle, 0.0, 1.0);
}

}  // namespace lineservo::servo
