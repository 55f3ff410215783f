#include "features/line/border_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lineservo::features {
namespace {

constexpr int kSpread = 3;  // a border's directions scatter over about so many bins each way
constexpr int kAll = BorderField::kDirections;
constexpr double kAxisError_deg = 0.3;  // of BorderPoint::theta_rad

// Bins to either side that hold all points within an angle: those have an error of their own, and the angle
// starts anywhere in its bin.
constexpr int reach_of(double within_rad) {
  return static_cast<int>(within_rad * (kAll / kPi) + kAxisError_deg) + 1;
}
constexpr int kReach = reach_of(BorderField::kWidest_rad);

// Of an axis in [−π/2, π/2]; both ends are the same axis.
int direction_bin(double theta_rad) {
  const int bin = static_cast<int>((theta_rad + kPi / 2.0) * (kAll / kPi));
  return bin >= kAll ? bin - kAll : bin;
}

double axis_angle(double theta_rad) {
  if (theta_rad > kPi / 2.0) return theta_rad - kPi;
  return theta_rad <= -kPi / 2.0 ? theta_rad + kPi : theta_rad;
}

std::size_t index(int bin) {
  return static_cast<std::size_t>(bin);
}

}  // namespace

// A counting sort by direction that keeps the order within a bin.
void BorderField::assign(const std::vector<BorderPoint>& points) {
  bins_.resize(points.size());
  first_.fill(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    bins_[i] = static_cast<std::uint8_t>(direction_bin(points[i].theta_rad));
    ++first_[bins_[i] + 1u];
  }
  for (std::size_t bin = 0; bin < kAll; ++bin) first_[bin + 1] += first_[bin];
  const std::size_t repeated = first_[2 * kReach + 1];
  points_.resize(points.size() + repeated);
  std::array<std::uint32_t, kAll + 1> next = first_;
  free_length_.fill(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points_[next[bins_[i]]++] = points[i];
    free_length_[bins_[i]] += points[i].length;
  }
  for (std::size_t i = 0; i < repeated; ++i) points_[points.size() + i] = points_[i];
  for (std::size_t bin = 0; bin < kAll; ++bin)
    for (std::size_t i = first_[bin]; i < first_[bin + 1]; ++i) bins_[i] = static_cast<std::uint8_t>(bin);
  use_.assign(points.size(), PointUse::free);
  is_stale_.fill(false);
}

void BorderField::release_deferred() {
  for (std::size_t i = 0; i < use_.size(); ++i)
    if (use_[i] == PointUse::deferred) set_use(i, PointUse::free);
}

std::size_t BorderField::first_of(int bin) const {
  return bin <= kAll ? first_[index(bin)] : use_.size() + first_[index(bin - kAll)];
}

std::span<const BorderPoint> BorderField::near(double theta_rad, double within_rad) const {
  assert(within_rad <= kWidest_rad);
  const int reach = reach_of(within_rad);
  const int bin = direction_bin(std::remainder(theta_rad, kPi));
  const int from = bin >= reach ? bin - reach : bin - reach + kAll;
  const std::size_t begin = first_of(from), end = first_of(from + 2 * reach + 1);
  return {points_.data() + begin, end - begin};
}

void BorderField::measure_bins() {
  for (std::size_t bin = 0; bin < kAll; ++bin) {
    if (!is_stale_[bin]) continue;
    is_stale_[bin] = false;
    free_length_[bin] = 0.0;
    for (std::size_t i = first_[bin]; i < first_[bin + 1]; ++i)
      free_length_[bin] += points_[i].length * int{use_[i] == PointUse::free};
  }
}

std::optional<DirectionPeak> BorderField::strongest_direction() {
  measure_bins();
  std::array<double, kAll + 2 * kSpread> around;  // the ends repeated
  std::copy(free_length_.end() - kSpread, free_length_.end(), around.begin());
  std::copy(free_length_.begin(), free_length_.end(), around.begin() + kSpread);
  std::copy(free_length_.begin(), free_length_.begin() + kSpread, around.end() - kSpread);
  const auto length = [&around](int bin) { return around[index(bin + kSpread)]; };
  double sum = 0.0;
  for (int k = -kSpread; k < kSpread; ++k) sum += length(k);
  double best = 0.0;
  int best_at = 0;
  for (int k = 0; k < kAll; ++k) {
    sum += length(k + kSpread);
    if (sum > best) {
      best = sum;
      best_at = k;
    }
    sum -= length(k - kSpread);
  }
  if (best <= 0.0) return std::nullopt;
  double moment = 0.0;
  for (int k = -kSpread; k <= kSpread; ++k) moment += length(best_at + k) * k;
  const double bin = best_at + 0.5 + moment / best;
  return DirectionPeak{axis_angle(bin * (kPi / kAll) - kPi / 2.0), best};
}

}  // namespace lineservo::features
