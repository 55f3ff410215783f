#include "servo/law/odometry.h"

#include <algorithm>

namespace lineservo::servo {
namespace {

constexpr std::chrono::nanoseconds kMemory = std::chrono::seconds(1);

double seconds_between(std::chrono::nanoseconds from, std::chrono::nanoseconds to) {
  return static_cast<double>((to - from).count()) * 1e-9;
}

}  // namespace

void Odometry::add(std::chrono::nanoseconds stamp, const Eigen::Vector2d& v_H_m_s, double yaw_rad) {
  if (entries_.empty()) {
    entries_.push_back({stamp, {Eigen::Vector2d::Zero(), yaw_rad}});
    return;
  }
  const Entry& last = entries_.back();
  if (stamp <= last.stamp) return;
  // Mid-point rule on the heading: p' = p + R(ψ̄) v dt.
  const Eigen::Rotation2Dd heading(0.5 * (last.pose.yaw_rad + yaw_rad));
  const double dt_s = seconds_between(last.stamp, stamp);
  const Eigen::Vector2d p = last.pose.translation_m + heading * v_H_m_s * dt_s;
  entries_.push_back({stamp, {p, yaw_rad}});
  while (entries_.front().stamp < stamp - kMemory) entries_.pop_front();
}

Motion Odometry::at(std::chrono::nanoseconds stamp) const {
  if (entries_.empty()) return {};
  const auto later = std::lower_bound(entries_.begin(), entries_.end(), stamp,
                                      [](const Entry& e, std::chrono::nanoseconds t) { return e.stamp < t; });
  if (later == entries_.end()) return entries_.back().pose;
  if (later == entries_.begin()) return entries_.front().pose;
  const auto earlier = std::prev(later);
  const double share = seconds_between(earlier->stamp, stamp) / seconds_between(earlier->stamp, later->stamp);
  const Motion &a = earlier->pose, &b = later->pose;
  return {a.translation_m + share * (b.translation_m - a.translation_m),
          a.yaw_rad + share * (b.yaw_rad - a.yaw_rad)};
}

}  // namespace lineservo::servo
