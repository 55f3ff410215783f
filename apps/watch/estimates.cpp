#include "apps/watch/estimates.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

double between(double a, double b, double share) {
  return a + share * (b - a);
}

EstimateAt between(const EstimateAt& a, const EstimateAt& b, servo::Time t) {
  const double share = servo::seconds(t - a.t) / servo::seconds(b.t - a.t);
  EstimateAt e;
  e.t = t;
  e.height_m = between(a.height_m, b.height_m, share);
  e.roll_rad = between(a.roll_rad, b.roll_rad, share);
  e.pitch_rad = between(a.pitch_rad, b.pitch_rad, share);
  e.v_H_m_s = a.v_H_m_s + share * (b.v_H_m_s - a.v_H_m_s);
  e.odometry.translation_m =
      a.odometry.translation_m + share * (b.odometry.translation_m - a.odometry.translation_m);
  e.odometry.yaw_rad = between(a.odometry.yaw_rad, b.odometry.yaw_rad, share);
  return e;
}

}  // namespace

Estimates::Estimates(double height_m) : is_constant_(true) {
  rows_.emplace_back();
  rows_.front().height_m = height_m;
}

Estimates::Estimates(std::vector<EstimateAt> rows, std::string name)
    : rows_(std::move(rows)), name_(std::move(name)) {}

EstimateAt Estimates::at(servo::Time t) const {
  if (is_constant_) return rows_.front();
  const auto later = std::lower_bound(rows_.begin(), rows_.end(), t,
                                      [](const EstimateAt& e, servo::Time time) { return e.t < time; });
  if (later != rows_.end() && later->t == t) return *later;
  if (later == rows_.end() || later == rows_.begin())
    throw InputError(fmt::format("{}: holds {:.3f} to {:.3f} s; there is a frame at {:.3f} s", name_,
                                 servo::seconds(rows_.front().t), servo::seconds(rows_.back().t),
                                 servo::seconds(t)));
  return between(*std::prev(later), *later, t);
}

}  // namespace lineservo::apps
