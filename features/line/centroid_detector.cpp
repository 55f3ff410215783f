#include "features/line/centroid_detector.h"

#include "features/geometry/angles.h"
#include "features/line/mask_pixels.h"

namespace lineservo::features {
namespace {

// Whole numbers: exact up to masks of 4096 px a side.
struct Moments {
  std::int64_t m00 = 0, m10 = 0, m01 = 0, m20 = 0, m11 = 0, m02 = 0;
};

Moments moments_of(const PackedMask& mask) {
  Moments m;
  for_each_pixel(mask, [&m](std::int64_t x, std::int64_t y) {
    ++m.m00;
    m.m10 += x;
    m.m01 += y;
    m.m20 += x * x;
    m.m11 += x * y;
    m.m02 += y * y;
  });
  return m;
}

}  // namespace

// The major axis has the angle φ = ½ atan2(2 μ11, μ20 − μ02), the normal stands on it.
std::vector<ImageLine> CentroidDetector::find(const PackedMask& mask) {
  const Moments m = moments_of(mask);
  const auto area = static_cast<double>(m.m00);
  const double cx = static_cast<double>(m.m10) / area, cy = static_cast<double>(m.m01) / area;
  const double mu20 = static_cast<double>(m.m20) / area - cx * cx;
  const double mu02 = static_cast<double>(m.m02) / area - cy * cy;
  const double mu11 = static_cast<double>(m.m11) / area - cx * cy;
  const double theta_rad = 0.5 * std::atan2(2.0 * mu11, mu20 - mu02) + kPi / 2.0;
  return {canonical_line(cx * std::cos(theta_rad) + cy * std::sin(theta_rad), theta_rad)};
}

}  // namespace lineservo::features
