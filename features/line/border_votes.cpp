#include "features/line/border_votes.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kLeastShare = 0.2;  // of the longest border of its kind: less is wear, or waits its turn

// std::floor without the call.
int floor_of(double x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero - int{x < towards_zero};
}

}  // namespace

OffsetVotes::OffsetVotes(const BorderField& border, double theta_rad) {
  const Eigen::Vector2d n(std::cos(theta_rad), std::sin(theta_rad));
  const double cos_gate = std::cos(kGate_rad);
  for (const BorderPoint& point : border.near(theta_rad, kGate_rad)) {
    if (border.use(border.number(point)) != PointUse::free) continue;
    const double facing = point.normal.dot(n);
    if (std::abs(facing) < cos_gate) continue;
    const int bin = floor_of(point.p_L.dot(n) / kBin) + kBins / 2;
    if (bin < 0 || bin >= kBins) continue;
    length_[facing > 0.0][static_cast<std::size_t>(bin)] += point.length;
    first_ = std::min(first_, static_cast<std::size_t>(bin));
    last_ = std::max(last_, static_cast<std::size_t>(bin));
  }
}

// A peak is a run of three bins that its neighbours do not exceed; its offset is their centroid.
std::vector<OffsetPeak> OffsetVotes::peaks(bool rising, double min_length) const {
  const auto& length = length_[rising];
  const auto run = [&length](std::size_t k) { return length[k - 1] + length[k] + length[k + 1]; };
  double longest = 0.0;
  const std::size_t from = std::max<std::size_t>(first_, 3) - 1,
                    to = std::min<std::size_t>(last_ + 2, kBins - 2);
  for (std::size_t k = from - 1; k < to + 1; ++k) longest = std::max(longest, run(k));
  if (longest < min_length) return {};
  min_length = std::max(min_length, kLeastShare * longest);
  std::vector<OffsetPeak> found;
  for (std::size_t k = from; k < to; ++k) {
    const double here = run(k);
    if (here < min_length || here < run(k - 1) || here <= run(k + 1)) continue;
    const double centroid = (length[k + 1] - length[k - 1]) / here;
    found.push_back({(static_cast<double>(k) - 0.5 * kBins + 0.5 + centroid) * kBin, here});
  }
  return found;
}

}  // namespace lineservo::features
