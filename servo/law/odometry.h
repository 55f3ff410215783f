#pragma once

#include <Eigen/Core>
#include <chrono>
#include <deque>

#include "servo/law/motion.h"

namespace lineservo::servo {

/// Dead reckoning: integrates the velocity and yaw estimates, and remembers the last second.
class Odometry {
 public:
  /// Adds an estimate; stamps must not go back (one that does is ignored).
  void add(std::chrono::nanoseconds stamp, const Eigen::Vector2d& v_H_m_s, double yaw_rad);

  /// The pose at an instant, interpolated; before the memory begins its oldest pose, after its end the
  /// newest.
  Motion at(std::chrono::nanoseconds stamp) const;

 private:
  struct Entry {
    std::chrono::nanoseconds stamp;
    Motion pose;
  };
  std::deque<Entry> entries_;
};

}  // namespace lineservo::servo
