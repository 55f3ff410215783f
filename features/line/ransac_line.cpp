#include "features/line/ransac_line.h"

#include <algorithm>
#include <cstdint>

#include "features/line/point_line.h"

namespace lineservo::features {
namespace {

// Knuth's MMIX congruence: enough to pick pairs, the same everywhere.
class Picker {
 public:
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>((state_ >> 33) % count);
  }

 private:
  std::uint64_t state_ = 1;
};

std::vector<PixelPoint> supporters(const std::vector<PixelPoint>& points, const ImageLine& line,
                                   double reach_px) {
  std::vector<PixelPoint> near;
  for (const PixelPoint& p : points)
    if (std::abs(line.across(p)) <= reach_px) near.push_back(p);
  return near;
}

template <typename Try>
void for_pairs(std::size_t points, int rounds, Try&& attempt) {
  if (points * (points - 1) / 2 <= static_cast<std::size_t>(rounds)) {
    for (std::size_t i = 0; i < points; ++i)
      for (std::size_t j = i + 1; j < points; ++j) attempt(i, j);
    return;
  }
  Picker picker;
  for (int round = 0; round < rounds; ++round) attempt(picker.below(points), picker.below(points));
}

}  // namespace

std::optional<ImageLine> ransac_line(const std::vector<PixelPoint>& points, const RansacOptions& options) {
  std::vector<PixelPoint> best;
  for_pairs(points.size(), options.rounds, [&](std::size_t i, std::size_t j) {
    const PixelPoint &a = points[i], &b = points[j];
    if (std::hypot(a.x - b.x, a.y - b.y) < 1.0) return;
    std::vector<PixelPoint> near = supporters(points, line_through(a, b), options.reach_px);
    if (near.size() > best.size()) best = std::move(near);
  });
  if (std::ssize(best) < std::max(2, options.least_points)) return std::nullopt;
  return fit_line(best);
}

}  // namespace lineservo::features
