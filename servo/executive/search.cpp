#include "servo/executive/search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lineservo::servo {

// The line's direction and its left in the odometry's origin: the vehicle turns by −θ onto the line.
Search::Search(const std::optional<LastLine>& line, int attempt, Time now, const SearchOptions& options)
    : options_(options), began_(now) {
  if (!line) return;
  const Eigen::Rotation2Dd heading(line->odometry.yaw_rad - line->angle_rad);
  const Eigen::Vector2d along = heading * Eigen::Vector2d::UnitX(), left = heading * Eigen::Vector2d::UnitY();
  const Eigen::Vector2d last = line->odometry.translation_m - line->offset_m * left;
  const Eigen::Vector2d to_side = std::copysign(options.side_m, -line->offset_m) * left;
  if (attempt == 0) {
    places_ = {last - options.back_m * along, last + to_side, last};
  } else {
    places_ = {last - options.back_m * along, last + options.ahead_m * along};
  }
}

Eigen::Vector2d Search::velocity_H_m_s(const Observation& observation) {
  constexpr double kGain_per_s = 1.5;
  if (seconds(observation.now - began_) < options_.wait_s) return Eigen::Vector2d::Zero();
  while (!places_.empty()) {
    const Eigen::Vector2d to_go_m = after(observation.estimate.odometry_now, places_.back());
    const double way_m = to_go_m.norm();
    if (way_m > options_.reached_m) return std::min(kGain_per_s, options_.speed_m_s / way_m) * to_go_m;
    places_.pop_back();
  }
  return Eigen::Vector2d::Zero();
}

bool Search::is_over(Time now) const {
  const double searched_s = seconds(now - began_);
  return searched_s > options_.limit_s || (places_.empty() && searched_s > 2.0 * options_.wait_s);
}

}  // namespace lineservo::servo
