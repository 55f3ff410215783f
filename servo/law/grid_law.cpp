#include "servo/law/grid_law.h"

#include <algorithm>
#include <cmath>

#include "servo/law/published_followers.h"

namespace lineservo::servo {

using features::LineFeature;
using features::radians;

namespace {

std::vector<LineFeature> finite(const std::vector<LineFeature>& lines) {
  std::vector<LineFeature> kept;
  for (const LineFeature& line : lines)
    if (std::isfinite(line.rho) && std::isfinite(line.theta_rad) && line.covariance.allFinite())
      kept.push_back(line);
  return kept;
}

}  // namespace

// x cosθ + y sinθ = ρ with x' = y, y' = −x is x' cos(θ − π/2) + y' sin(θ − π/2) = ρ.
LineFeature quarter_turned(LineFeature line) {
  line.theta_rad -= 0.5 * features::kPi;
  if (line.theta_rad <= -0.5 * features::kPi) {
    line.theta_rad += features::kPi;
    line.rho = -line.rho;
  }
  line.begin = {line.begin.y, -line.begin.x};
  line.end = {line.end.y, -line.end.x};
  return line;
}

Command GridLaw::follow(const Observation& observation, const FollowGoal& goal) {
  const double dt_s = step_s(observation);
  const auto line = vertical(observation, dt_s);
  AttitudeCommand command = beside(line, dt_s, goal);
  if (line || !on_plain_line(observation)) command.pitch_rad = speed_pitch(observation, goal.speed_m_s);
  return command;
}

// The goal node lies where the vertical and the horizontal line cross (§VI-B).
std::optional<Command> GridLaw::hover(const Observation& observation, const FollowGoal& goal) {
  const double dt_s = step_s(observation);
  AttitudeCommand command = beside(vertical(observation, dt_s), dt_s, goal);
  if (const auto line = horizontal(observation, dt_s)) {
    command.pitch_rad = pitch_.update(-line->offset_m, dt_s, options_.pitch, tilt_limit_rad());
  } else {
    pitch_.reset();
    command.pitch_rad = speed_pitch(observation, 0.0);
  }
  return command;
}

// Error to the right asks for right side down; a line that leans right (θ > 0), for a turn to the right.
AttitudeCommand GridLaw::beside(const std::optional<Line>& line, double dt_s, const FollowGoal& goal) {
  AttitudeCommand command = level_flight(goal);
  if (!line) {
    roll_.reset();
    yaw_.reset();
    return command;
  }
  command.roll_rad = roll_.update(line->offset_m, dt_s, options_.roll, tilt_limit_rad());
  command.yaw_rate_rad_s =
      yaw_.update(-line->theta_rad, dt_s, options_.yaw, radians(options_.yaw_rate_limit_deg_s));
  return command;
}

// "An imaginary horizontal line in front" (§VI-B), read as one that runs ahead at the wanted speed v*: its
// distance times K_p is the pitch that v* takes against the drag, and its error grows at v* − v:
//   pitch = trim v* + K_d (v* − v).
double GridLaw::speed_pitch(const Observation& observation, double speed_m_s) const {
  const double pitch =
      options_.trim_rad_per_m_s * speed_m_s + speed_hold(observation, speed_m_s, options_.pitch.kd);
  return std::clamp(pitch, -tilt_limit_rad(), tilt_limit_rad());
}

std::optional<GridLaw::Line> GridLaw::vertical(const Observation& o, double dt_s) {
  const auto tracked = vertical_.update(dt_s, o.estimate.capture_height_m, finite(o.features.law.lines));
  if (!tracked) return std::nullopt;
  return Line{tracked->line.rho * o.estimate.capture_height_m, tracked->line.theta_rad};
}

// The horizontal line nearest to the vehicle starts the track, and stays the goal's.
std::optional<GridLaw::Line> GridLaw::horizontal(const Observation& o, double dt_s) {
  std::vector<LineFeature> lines = finite(o.features.law.lines);
  std::transform(lines.begin(), lines.end(), lines.begin(), quarter_turned);
  std::sort(lines.begin(), lines.end(),
            [](const LineFeature& a, const LineFeature& b) { return std::abs(a.rho) < std::abs(b.rho); });
  const auto tracked = horizontal_.update(dt_s, o.estimate.capture_height_m, lines);
  if (!tracked) return std::nullopt;
  return Line{tracked->line.rho * o.estimate.capture_height_m, tracked->line.theta_rad};
}

double GridLaw::step_s(const Observation& observation) {
  const double dt_s = last_captured_ ? seconds(observation.captured - *last_captured_) : 0.0;
  last_captured_ = observation.captured;
  return dt_s;
}

double GridLaw::tilt_limit_rad() const {
  return radians(options_.tilt_limit_deg);
}

}  // namespace lineservo::servo
