#pragma once

#include <Eigen/Geometry>
#include <deque>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// The poses of a body over the last moments, to be asked for in between.
class MotionTrack {
 public:
  /// Times must grow.
  void add(Time t, const Eigen::Isometry3d& X_WB);
  /// Forgets what is not needed to know the pose from `t` on.
  void forget_before(Time t);
  bool empty() const { return poses_.empty(); }
  Time last() const { return poses_.back().t; }
  /// Places in between are taken in a straight line, attitudes along the shortest turn; beyond the ends the
  /// nearest pose holds. Requires that the track is not empty.
  Eigen::Isometry3d at(Time t) const;

 private:
  struct Pose {
    Time t;
    Eigen::Vector3d p_WB;
    Eigen::Quaterniond q_WB;
  };
  std::deque<Pose> poses_;
};

}  // namespace lineservo::vehicle
