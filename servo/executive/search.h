#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// How a line that went out of sight is looked for.
struct SearchOptions {
  double wait_s = 1.0;  ///< at rest first: most of what goes out of sight comes back by itself
  double speed_m_s = 0.15;
  double side_m = 0.2;   ///< to the side where the line was
  double back_m = 0.3;   ///< along the line, where it was in sight
  double ahead_m = 0.6;  ///< the second time: across a gap
  double reached_m = 0.04;
  double limit_s = 12.0;
};

/// Where a line was when it was seen last.
struct LastLine {
  Motion odometry;         ///< of the vehicle then
  double offset_m = 0.0;   ///< of the vehicle, to the left of the line
  double angle_rad = 0.0;  ///< of the line, as in LineFeature
};

/// The way to a line that went out of sight: over the place where it was last, to the side where it lay, and
/// back along it; the second time across the gap. It keeps within about half a metre of that place.
class Search {
 public:
  Search() = default;
  /// `attempt` counts from 0. Without a line to go by it waits.
  Search(const std::optional<LastLine>& line, int attempt, Time now, const SearchOptions& options = {});

  /// The velocity to fly with, heading frame.
  Eigen::Vector2d velocity_H_m_s(const Observation& observation);
  /// Nothing is left to try.
  bool is_over(Time now) const;

 private:
  SearchOptions options_;
  Time began_{0};
  std::vector<Eigen::Vector2d> places_;  ///< still to be looked at, in the odometry's origin; last one first
};

}  // namespace lineservo::servo
