#include "servo/executive/leg_compass.h"

#include <algorithm>
#include <cmath>

namespace lineservo::servo {

// A line has no direction: its heading is known mod π.
double LegCompass::off_rad(const Observation& observation, const features::LineFeature& line) const {
  const double line_heading_rad = observation.estimate.odometry_at_capture.yaw_rad - line.theta_rad;
  return std::remainder(line_heading_rad - *heading_rad_, features::kPi);
}

std::size_t LegCompass::straight_on(const Observation& observation) {
  const auto& lines = observation.features.lines;
  const Time captured = std::max(last_, observation.captured);  // a frame out of order takes no time
  const double dt_s = heading_rad_ ? seconds(captured - last_) : 0.0;
  last_ = captured;
  if (!line_to_follow(observation)) return 0;
  if (!heading_rad_)
    heading_rad_ = observation.estimate.odometry_at_capture.yaw_rad - lines.front().theta_rad;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double off = off_rad(observation, lines[k]);
    if (!(std::abs(off) < options_.off_rad)) continue;
    off_for_s_ = 0.0;
    *heading_rad_ += (1.0 - std::exp(-dt_s / options_.time_constant_s)) * off;
    return k;
  }
  off_for_s_ += dt_s;
  return 0;
}

}  // namespace lineservo::servo
