#include "features/line/combined_detector.h"

#include <algorithm>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kNear = 0.1;  // of the mask's long side
constexpr double kNear_rad = radians(15.0);

}  // namespace

std::vector<ImageLine> CombinedDetector::find(const PackedMask& mask) {
  std::vector<ImageLine> lines = skeleton_.find(mask);
  const std::vector<ImageLine> centroids = slices_.find(mask);
  if (centroids.empty()) return lines;
  const ImageLine& line = centroids.front();
  const double near_px = kNear * std::max(mask.width(), mask.height());
  const auto partner = std::find_if(lines.begin(), lines.end(), [&](const ImageLine& other) {
    const LineDifference d = difference(other, line);
    return std::abs(d.rho_px) < near_px && std::abs(d.theta_rad) < kNear_rad;
  });
  if (partner == lines.end()) {
    lines.insert(lines.begin(), line);
    return lines;
  }
  const LineDifference d = difference(*partner, line);
  *partner = canonical_line(line.rho_px + 0.5 * d.rho_px, line.theta_rad + 0.5 * d.theta_rad);
  std::rotate(lines.begin(), partner, partner + 1);
  return lines;
}

}  // namespace lineservo::features
