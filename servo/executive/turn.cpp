#include "servo/executive/turn.h"

#include <cmath>
#include <vector>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

using features::LineFeature;

/// How near its heading a turn takes a line for the next edge.
constexpr double kNewLine_rad = features::radians(25.0);

/// The line whose angle (mod π) is nearest to a given one, if within the bound.
const LineFeature* nearest_line(const std::vector<LineFeature>& lines, double theta_rad, double bound_rad) {
  const LineFeature* best = nullptr;
  for (const LineFeature& line : lines) {
    const double off_rad = features::axis_difference(line.theta_rad, theta_rad);
    if (off_rad < bound_rad) {
      bound_rad = off_rad;
      best = &line;
    }
  }
  return best;
}

}  // namespace

std::optional<double> Turn::correct(const Observation& observation) {
  const double yaw_at_capture_rad = observation.estimate.odometry_at_capture.yaw_rad;
  const double left_at_capture_rad = heading_out_rad_ - yaw_at_capture_rad;
  if (std::abs(left_at_capture_rad) > kNewLine_rad) return std::nullopt;
  const LineFeature* line = nearest_line(observation.features.lines, -left_at_capture_rad, kNewLine_rad);
  if (!line) return std::nullopt;
  heading_out_rad_ = yaw_at_capture_rad - std::remainder(line->theta_rad, features::kPi);
  return -left_rad(observation);
}

}  // namespace lineservo::servo
