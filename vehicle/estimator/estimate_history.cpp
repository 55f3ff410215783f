#include "vehicle/estimator/estimate_history.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lineservo::vehicle {

Estimate interpolated(const Estimate& a, const Estimate& b, double w) {
  const auto mix = [w](const auto& from, const auto& to) { return (from + w * (to - from)); };
  Estimate e;
  e.stamp = a.stamp + Time(std::llround(w * static_cast<double>((b.stamp - a.stamp).count())));
  e.roll_rad = mix(a.roll_rad, b.roll_rad);
  e.pitch_rad = mix(a.pitch_rad, b.pitch_rad);
  e.yaw_rad = mix(a.yaw_rad, b.yaw_rad);  // counts on past ±π, so there is no jump to step over
  e.w_B_rad_s = a.w_B_rad_s + w * (b.w_B_rad_s - a.w_B_rad_s);
  e.v_H_m_s = a.v_H_m_s + w * (b.v_H_m_s - a.v_H_m_s);
  e.a_H_m_s2 = a.a_H_m_s2 + w * (b.a_H_m_s2 - a.a_H_m_s2);
  e.height_m = mix(a.height_m, b.height_m);
  e.range_heard = a.range_heard;
  e.flow_heard = a.flow_heard;
  return e;
}

void EstimateHistory::add(const Estimate& estimate) {
  ring_[added_ % kSize] = estimate;
  ++added_;
}

Estimate EstimateHistory::at(Time t) const {
  assert(added_ > 0);
  const std::size_t kept = std::min(added_, kSize);
  const Estimate* after = &newest();
  if (t >= after->stamp) return *after;
  for (std::size_t back = 1; back < kept; ++back) {
    const Estimate* before = &ring_[(added_ - 1 - back) % kSize];
    if (before->stamp <= t) {
      return interpolated(*before, *after,
                          seconds(t - before->stamp) / seconds(after->stamp - before->stamp));
    }
    after = before;
  }
  return *after;
}

}  // namespace lineservo::vehicle
