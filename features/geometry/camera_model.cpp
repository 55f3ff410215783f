#include "features/geometry/camera_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lineservo::features {
namespace {

std::string faults(const CameraParameters& p) {
  std::string list;
  const auto require = [&list](bool holds, const char* fault) {
    if (!holds) list += (list.empty() ? "" : "; ") + std::string(fault);
  };
  require(p.width_px >= 16 && p.width_px <= 16384, "width must be 16 to 16384 px");
  require(p.height_px >= 16 && p.height_px <= 16384, "height must be 16 to 16384 px");
  require(std::isfinite(p.fx_px) && p.fx_px > 0.0, "fx must be positive");
  require(std::isfinite(p.fy_px) && p.fy_px > 0.0, "fy must be positive");
  require(std::isfinite(p.cx_px) && std::isfinite(p.cy_px), "the principal point must be finite");
  require(std::all_of(p.distortion.begin(), p.distortion.end(), [](double k) { return std::isfinite(k); }),
          "distortion must be finite");
  return list;
}

}  // namespace

CameraModel::CameraModel(const CameraParameters& parameters) : parameters_(parameters) {
  if (const std::string list = faults(parameters); !list.empty())
    throw std::invalid_argument("camera: " + list);
  has_distortion_ = std::any_of(parameters.distortion.begin(), parameters.distortion.end(),
                                [](double k) { return k != 0.0; });
  if (!undoes_corners())
    throw std::invalid_argument("camera: the distortion cannot be undone at the image's corners");
}

bool CameraModel::undoes_corners() const {
  for (const double x : {-0.5, width_px() - 0.5}) {
    for (const double y : {-0.5, height_px() - 0.5}) {
      const NormalizedPoint ray = normalize({x, y});
      const PixelPoint back = project(ray);
      if (!(std::hypot(back.x - x, back.y - y) < 0.01) || folds_before(ray)) return false;
    }
  }
  return true;
}

// Where the radial polynomial turns back, det ∂x'/∂x ≤ 0 and two rays share a pixel: behind the fold the
// inverse lands on the wrong one of them.
bool CameraModel::folds_before(NormalizedPoint point) const {
  constexpr int kSteps = 64;
  for (int k = 1; k <= kSteps; ++k) {
    const double share = static_cast<double>(k) / kSteps;
    if (!(distortion_slope({share * point.x, share * point.y}).determinant() > 0.0)) return true;
  }
  return false;
}

PixelPoint CameraModel::project(NormalizedPoint point) const {
  const NormalizedPoint d = has_distortion_ ? distort(point) : point;
  return {parameters_.fx_px * d.x + parameters_.cx_px, parameters_.fy_px * d.y + parameters_.cy_px};
}

NormalizedPoint CameraModel::normalize(PixelPoint pixel) const {
  const NormalizedPoint distorted{(pixel.x - parameters_.cx_px) / parameters_.fx_px,
                                  (pixel.y - parameters_.cy_px) / parameters_.fy_px};
  return has_distortion_ ? undistort(distorted) : distorted;
}

// Brown–Conrady, as in OpenCV's calib3d:
//   x' = x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²)
//   y' = y (1 + k1 r² + k2 r⁴ + k3 r⁶) + p1 (r² + 2 y²) + 2 p2 x y
NormalizedPoint CameraModel::distort(NormalizedPoint point) const {
  const auto [k1, k2, p1, p2, k3] = parameters_.distortion;
  const double x = point.x, y = point.y;
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

// ∂(x', y')/∂(x, y) of the above.
CameraModel::Slope CameraModel::distortion_slope(NormalizedPoint point) const {
  const auto [k1, k2, p1, p2, k3] = parameters_.distortion;
  const double x = point.x, y = point.y;
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));  // d(radial)/d(r²) · 2
  return {radial + x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y,
          radial + y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x};
}

NormalizedPoint CameraModel::undistort(NormalizedPoint distorted) const {
  double x = distorted.x, y = distorted.y;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const NormalizedPoint at = distort({x, y});
    const double ex = at.x - distorted.x, ey = at.y - distorted.y;
    if (ex * ex + ey * ey < 1e-26) break;
    const Slope j = distortion_slope({x, y});
    const double det = j.determinant();
    if (std::abs(det) < 1e-12) break;
    x -= (j.yy * ex - j.xy * ey) / det;
    y -= (j.xx * ey - j.xy * ex) / det;
  }
  return {x, y};
}

}  // namespace lineservo::features
