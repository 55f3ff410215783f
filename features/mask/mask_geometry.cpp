#include "features/mask/mask_geometry.h"

#include <Eigen/LU>
#include <stdexcept>

namespace lineservo::features {
namespace {

void require_size(int mask_width_px, int mask_height_px) {
  const auto fits = [](int size_px) { return size_px >= 16 && size_px <= 4096; };
  if (!fits(mask_width_px) || !fits(mask_height_px))
    throw std::invalid_argument("mask: width and height must be 16 to 4096 px");
}

// x_mask = (x_frame + ½) s − ½ with x_frame = f x + c, so f_mask = f s and c_mask = (c + ½) s − ½.
Eigen::Matrix3d mask_pinhole(const CameraModel& camera, int mask_width_px, int mask_height_px) {
  const CameraParameters& p = camera.parameters();
  const double sx = static_cast<double>(mask_width_px) / p.width_px;
  const double sy = static_cast<double>(mask_height_px) / p.height_px;
  Eigen::Matrix3d K;
  K << p.fx_px * sx, 0.0, (p.cx_px + 0.5) * sx - 0.5,  //
      0.0, p.fy_px * sy, (p.cy_px + 0.5) * sy - 0.5,   //
      0.0, 0.0, 1.0;
  return K;
}

}  // namespace

MaskGeometry::MaskGeometry(const CameraModel& camera, int mask_width_px, int mask_height_px)
    : camera_(camera), width_px_(mask_width_px), height_px_(mask_height_px) {
  require_size(mask_width_px, mask_height_px);
  pinhole_ = mask_pinhole(camera, mask_width_px, mask_height_px);
  pinhole_inverse_ = pinhole_.inverse();
  if (!camera.has_distortion()) return;
  const std::size_t pixels = index(0, height_px_);
  left_borders_.reserve(pixels);
  top_borders_.reserve(pixels);
  const auto looked_up = [this](double x_px, double y_px) {
    const NormalizedPoint at = normalize({x_px, y_px});
    return Eigen::Vector2f(static_cast<float>(at.x), static_cast<float>(at.y));
  };
  for (int y = 0; y < height_px_; ++y) {
    for (int x = 0; x < width_px_; ++x) {
      left_borders_.push_back(looked_up(x - 0.5, y));
      top_borders_.push_back(looked_up(x, y - 0.5));
    }
  }
}

NormalizedPoint MaskGeometry::normalize(PixelPoint mask_px) const {
  const CameraParameters& p = camera_.parameters();
  return camera_.normalize(
      {(mask_px.x + 0.5) * p.width_px / width_px_ - 0.5, (mask_px.y + 0.5) * p.height_px / height_px_ - 0.5});
}

PixelPoint MaskGeometry::project(NormalizedPoint point) const {
  const CameraParameters& p = camera_.parameters();
  const PixelPoint frame_px = camera_.project(point);
  return {(frame_px.x + 0.5) * width_px_ / p.width_px - 0.5,
          (frame_px.y + 0.5) * height_px_ / p.height_px - 0.5};
}

}  // namespace lineservo::features
