#include "features/line/border_votes.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr int kDirections = 180;     // bins of 1° over half a turn
constexpr double kLeastShare = 0.2;  // of the longest border of its kind: less is wear, or waits its turn
constexpr int kSpread = 3;           // a border's directions scatter over about so many bins each way

int direction_bin(double theta_rad) {
  const int bin = static_cast<int>((theta_rad + kPi / 2.0) * (kDirections / kPi));
  return bin >= kDirections ? bin - kDirections : bin;
}

double axis_angle(double theta_rad) {
  if (theta_rad > kPi / 2.0) return theta_rad - kPi;
  return theta_rad <= -kPi / 2.0 ? theta_rad + kPi : theta_rad;
}

// The histogram around a turn, so that a window never has to wrap.
using Directions = std::array<double, kDirections + 2 * kSpread>;

Directions direction_lengths(const std::vector<BorderPoint>& points, const std::vector<PointUse>& use) {
  Directions lengths = {};
  for (std::size_t i = 0; i < points.size(); ++i)
    if (use[i] == PointUse::free)
      lengths[static_cast<std::size_t>(kSpread + direction_bin(points[i].theta_rad))] += points[i].length;
  for (std::size_t k = 0; k < kSpread; ++k) {
    lengths[k] = lengths[k + kDirections];
    lengths[k + kDirections + kSpread] = lengths[k + kSpread];
  }
  return lengths;
}

}  // namespace

std::optional<DirectionPeak> strongest_direction(const std::vector<BorderPoint>& points,
                                                 const std::vector<PointUse>& use) {
  const Directions lengths = direction_lengths(points, use);
  constexpr std::size_t window = 2 * kSpread + 1;
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < window; ++k) sum += lengths[k];
  double best = 0.0;
  std::size_t best_at = 0;
  for (std::size_t k = 0; k < kDirections; ++k) {
    sum += lengths[k + window - 1];
    if (sum > best) {
      best = sum;
      best_at = k;
    }
    sum -= lengths[k];
  }
  if (best <= 0.0) return std::nullopt;
  double moment = 0.0;
  for (std::size_t k = 0; k < window; ++k)
    moment += lengths[best_at + k] * (static_cast<double>(k) - kSpread);
  const double bin = static_cast<double>(best_at) + 0.5 + moment / best;
  return DirectionPeak{axis_angle(bin * (kPi / kDirections) - kPi / 2.0), best};
}

OffsetVotes::OffsetVotes(const std::vector<BorderPoint>& points, const std::vector<PointUse>& use,
                         double theta_rad) {
  const Eigen::Vector2d n(std::cos(theta_rad), std::sin(theta_rad));
  const double cos_gate = std::cos(kGate_rad);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (use[i] != PointUse::free) continue;
    const double facing = points[i].normal.dot(n);
    if (std::abs(facing) < cos_gate) continue;
    const int bin = static_cast<int>(std::floor(points[i].p_L.dot(n) / kBin)) + kBins / 2;
    if (bin >= 0 && bin < kBins) length_[facing > 0.0][static_cast<std::size_t>(bin)] += points[i].length;
  }
}

// A peak is a run of three bins that its neighbours do not exceed; its offset is their centroid.
std::vector<OffsetPeak> OffsetVotes::peaks(bool rising, double min_length) const {
  const auto& length = length_[rising];
  const auto run = [&length](std::size_t k) { return length[k - 1] + length[k] + length[k + 1]; };
  double longest = 0.0;
  for (std::size_t k = 1; k + 1 < kBins; ++k) longest = std::max(longest, run(k));
  min_length = std::max(min_length, kLeastShare * longest);
  std::vector<OffsetPeak> found;
  for (std::size_t k = 2; k + 2 < kBins; ++k) {
    const double here = run(k);
    if (here < min_length || here < run(k - 1) || here <= run(k + 1)) continue;
    const double centroid = (length[k + 1] - length[k - 1]) / here;
    found.push_back({(static_cast<double>(k) - 0.5 * kBins + 0.5 + centroid) * kBin, here});
  }
  return found;
}

}  // namespace lineservo::features
