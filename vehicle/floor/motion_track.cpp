#include "vehicle/floor/motion_track.h"

#include <algorithm>
#include <cassert>

namespace lineservo::vehicle {
namespace {

Eigen::Isometry3d pose(const Eigen::Vector3d& p_WB, const Eigen::Quaterniond& q_WB) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.linear() = q_WB.toRotationMatrix();
  X_WB.translation() = p_WB;
  return X_WB;
}

// Between attitudes a millisecond apart the chord is the arc, to 1e-10 of it.
Eigen::Quaterniond between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share) {
  const double sign = a.coeffs().dot(b.coeffs()) < 0.0 ? -1.0 : 1.0;
  return Eigen::Quaterniond((1.0 - share) * a.coeffs() + share * sign * b.coeffs()).normalized();
}

}  // namespace

void MotionTrack::add(Time t, const Eigen::Isometry3d& X_WB) {
  assert(poses_.empty() || t > poses_.back().t);
  poses_.push_back({t, X_WB.translation(), Eigen::Quaterniond(X_WB.linear())});
}

void MotionTrack::forget_before(Time t) {
  while (poses_.size() > 1 && poses_[1].t <= t) poses_.pop_front();
}

Eigen::Isometry3d MotionTrack::at(Time t) const {
  assert(!poses_.empty());
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), t, [](Time time, const Pose& p) { return time < p.t; });
  if (after == poses_.begin()) return pose(after->p_WB, after->q_WB);
  const Pose& before = *std::prev(after);
  if (after == poses_.end()) return pose(before.p_WB, before.q_WB);
  const double share = seconds(t - before.t) / seconds(after->t - before.t);
  return pose((1.0 - share) * before.p_WB + share * after->p_WB, between(before.q_WB, after->q_WB, share));
}

}  // namespace lineservo::vehicle
