#include "features/line/point_line.h"

#include "features/geometry/angles.h"

namespace lineservo::features {

ImageLine fit_line(std::span<const PixelPoint> points) {
  double cx = 0.0, cy = 0.0;
  for (const PixelPoint& p : points) {
    cx += p.x / static_cast<double>(points.size());
    cy += p.y / static_cast<double>(points.size());
  }
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const PixelPoint& p : points) {
    xx += (p.x - cx) * (p.x - cx);
    xy += (p.x - cx) * (p.y - cy);
    yy += (p.y - cy) * (p.y - cy);
  }
  const double theta_rad = 0.5 * std::atan2(2.0 * xy, xx - yy) + kPi / 2.0;
  return canonical_line(cx * std::cos(theta_rad) + cy * std::sin(theta_rad), theta_rad);
}

}  // namespace lineservo::features
