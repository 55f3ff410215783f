#include "features/line/border_field.h"

#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr int kSpread = 3;  // a border's directions scatter over about so many bins each way
constexpr int kAll = BorderField::kDirections;

int direction_bin(double theta_rad) {
  const int bin = static_cast<int>(std::floor((theta_rad + kPi / 2.0) * (kAll / kPi)));
  return bin >= kAll ? bin - kAll : bin < 0 ? bin + kAll : bin;
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
  for (std::size_t i = 0; i < points.size(); ++i) points_[next[bins_[i]]++] = points[i];
  for (std::size_t i = 0; i < repeated; ++i) points_[points.size() + i] = points_[i];
  for (std::size_t bin = 0; bin < kAll; ++bin)
    for (std::size_t i = first_[bin]; i < first_[bin + 1]; ++i) bins_[i] = static_cast<std::uint8_t>(bin);
  use_.assign(points.size(), PointUse::free);
  is_stale_.fill(true);
}

void BorderField::set_use(std::size_t i, PointUse use) {
  if (use_[i] == use) return;
  use_[i] = use;
  is_stale_[bins_[i]] = true;
}

void BorderField::release_deferred() {
  for (std::size_t i = 0; i < use_.size(); ++i)
    if (use_[i] == PointUse::deferred) set_use(i, PointUse::free);
}

std::size_t BorderField::first_of(int bin) const {
  return bin <= kAll ? first_[index(bin)] : use_.size() + first_[index(bin - kAll)];
}

std::span<const BorderPoint> BorderField::near(double theta_rad) const {
  const int bin = direction_bin(std::remainder(theta_rad, kPi));
  const int from = bin >= kReach ? bin - kReach : bin - kReach + kAll;
  const std::size_t begin = first_of(from), end = first_of(from + 2 * kReach + 1);
  return {points_.data() + begin, end - begin};
}

void BorderField::measure_bins() {
  for (std::size_t bin = 0; bin < kAll; ++bin) {
    if (!is_stale_[bin]) continue;
    is_stale_[bin] = false;
    free_length_[bin] = 0.0;
    for (std::size_t i = first_[bin]; i < first_[bin + 1]; ++i)
      if (use_[i] == PointUse::free) free_length_[bin] += points_[i].length;
  }
}

std::optional<DirectionPeak> BorderField::strongest_direction() {
  measure_bins();
  const auto length = [this](int bin) { return free_length_[index((bin + kAll) % kAll)]; };
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
