#include "features/line/mask_support.h"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

namespace lineservo::features {
namespace {

constexpr double kLeastShare = 5e-4, kMostShare = 0.95;  // of the mask that is painted
constexpr double kLeastPainted = 0.55;                   // of the line between its ends
constexpr double kLeastLength = 0.1;                     // of the mask's long side
constexpr int kPlaces = 64;                              // where the width is measured
constexpr int kFewest = 3;                               // of them must show both sides of the paint
constexpr double kPixelVariance = 1.0 / 12.0;            // of rounding to pixels

bool painted(const PackedMask& mask, const PixelPoint& p) {
  const int x = static_cast<int>(std::floor(p.x + 0.5)), y = static_cast<int>(std::floor(p.y + 0.5));
  return x >= 0 && y >= 0 && x < mask.width() && y < mask.height() && mask.at(x, y);
}

bool in_mask(const PackedMask& mask, const PixelPoint& p) {
  return p.x > -0.5 && p.y > -0.5 && p.x < mask.width() - 0.5 && p.y < mask.height() - 0.5;
}

// The paint across a line at one place: how far it reaches to both sides.
struct Crossing {
  double along_px = 0.0, low_px = 0.0, high_px = 0.0;
  bool has_sides = false;  // both ends lie in view

  double width_px() const { return high_px - low_px; }
  double middle_px() const { return 0.5 * (low_px + high_px); }
};

Crossing crossing_at(const ImageLine& line, const PackedMask& mask, double along_px) {
  const PixelPoint p = line.at(along_px);
  const Eigen::Vector2d n = line.normal();
  const auto beyond = [&](double across_px) {
    return PixelPoint{p.x + across_px * n.x(), p.y + across_px * n.y()};
  };
  double low = 0.0, high = 0.0;
  while (painted(mask, beyond(low - 1.0))) low -= 1.0;
  while (painted(mask, beyond(high + 1.0))) high += 1.0;
  const bool has_sides = in_mask(mask, beyond(low - 1.0)) && in_mask(mask, beyond(high + 1.0));
  return {along_px, low - 0.5, high + 0.5, has_sides};
}

struct PaintedStretch {
  double from = 0.0, to = 0.0, share = 0.0;
};

std::optional<PaintedStretch> painted_stretch(const ImageLine& line, const PackedMask& mask) {
  const auto stretch = stretch_in_image(line, {mask.width(), mask.height()});
  if (!stretch) return std::nullopt;
  int hits = 0;
  PaintedStretch found;
  for (double along = stretch->first + 0.5; along < stretch->second; along += 1.0) {
    if (!painted(mask, line.at(along))) continue;
    if (hits++ == 0) found.from = along;
    found.to = along;
  }
  if (hits == 0) return std::nullopt;
  found.share = hits / (found.to - found.from + 1.0);
  return found;
}

std::vector<Crossing> crossings_of(const ImageLine& line, const PackedMask& mask,
                                   const PaintedStretch& stretch) {
  std::vector<Crossing> crossings;
  for (int k = 0; k < kPlaces; ++k) {
    const double along = stretch.from + (stretch.to - stretch.from) * (k + 0.5) / kPlaces;
    if (!painted(mask, line.at(along))) continue;
    const Crossing crossing = crossing_at(line, mask, along);
    if (crossing.has_sides) crossings.push_back(crossing);
  }
  return crossings;
}

double median_width(std::vector<Crossing> crossings) {
  const auto middle = crossings.begin() + static_cast<std::ptrdiff_t>(crossings.size() / 2);
  std::nth_element(crossings.begin(), middle, crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.width_px() < b.width_px(); });
  return middle->width_px();
}

// Least squares of the middles m = dρ − along dθ: σ² (Σ [1 −a; −a a²])⁻¹, side arms left out.
Eigen::Matrix2d covariance_of(const std::vector<Crossing>& crossings, double width_px) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Identity() * 1e-9;
  double squares = 0.0;
  int used = 0;
  for (const Crossing& c : crossings) {
    if (c.width_px() > 1.5 * width_px) continue;
    const Eigen::Vector2d g(1.0, -c.along_px);
    A += g * g.transpose();
    squares += c.middle_px() * c.middle_px();
    ++used;
  }
  return (squares / std::max(used, 1) + kPixelVariance) * A.inverse();
}

}  // namespace

bool may_hold_line(const PackedMask& mask) {
  if (mask.width() < 16 || mask.height() < 16) return false;
  const double share = static_cast<double>(mask.count()) / mask.width() / mask.height();
  return share > kLeastShare && share < kMostShare;
}

std::optional<ImageLine> supported_line(const ImageLine& line, const PackedMask& mask) {
  const auto stretch = painted_stretch(line, mask);
  if (!stretch || stretch->share < kLeastPainted) return std::nullopt;
  if (stretch->to - stretch->from < kLeastLength * std::max(mask.width(), mask.height())) return std::nullopt;
  const std::vector<Crossing> crossings = crossings_of(line, mask, *stretch);
  if (std::ssize(crossings) < kFewest) return std::nullopt;
  ImageLine supported = line;
  supported.width_px = median_width(crossings);
  supported.covariance = covariance_of(crossings, supported.width_px);
  supported.quality = std::min(1.0, stretch->share);
  supported.begin = line.at(stretch->from);
  supported.end = line.at(stretch->to);
  return supported;
}

}  // namespace lineservo::features
