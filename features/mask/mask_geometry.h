#pragma once

#include <Eigen/Core>
#include <vector>

#include "features/geometry/camera_model.h"
#include "features/geometry/points.h"

namespace lineservo::features {

/// Where the pixels of a resized mask lie on the normalised image plane of the camera that took the frame.
/// Built once; the resize keeps OpenCV's pixel centres, x_frame = (x_mask + ½) W_frame / W_mask − ½.
class MaskGeometry {
 public:
  /// Throws std::invalid_argument unless the mask measures 16 to 4096 pixels each way.
  MaskGeometry(const CameraModel& camera, int mask_width_px, int mask_height_px);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  bool has_distortion() const { return camera_.has_distortion(); }

  /// A position in the mask, in mask pixels, as an undistorted point.
  NormalizedPoint normalize(PixelPoint mask_px) const;
  /// The inverse of normalize().
  PixelPoint project(NormalizedPoint point) const;

  /// The border left of pixel (x, y), that is position (x − ½, y): looked up where the lens distorts.
  NormalizedPoint left_border(int x, int y) const;
  /// The border above pixel (x, y), that is position (x, y − ½).
  NormalizedPoint top_border(int x, int y) const;

  /// The pinhole part alone, mask pixels = K · (x, y, 1): all there is when the lens does not distort.
  const Eigen::Matrix3d& pinhole() const { return pinhole_; }
  const Eigen::Matrix3d& pinhole_inverse() const { return pinhole_inverse_; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px_) + static_cast<std::size_t>(x);
  }
  NormalizedPoint without_lens(double x_px, double y_px) const {
    return {pinhole_inverse_(0, 0) * x_px + pinhole_inverse_(0, 2),
            pinhole_inverse_(1, 1) * y_px + pinhole_inverse_(1, 2)};
  }

  CameraModel camera_;
  int width_px_;
  int height_px_;
  Eigen::Matrix3d pinhole_;
  Eigen::Matrix3d pinhole_inverse_;
  std::vector<Eigen::Vector2f> left_borders_, top_borders_;  ///< filled only for a lens that distorts
};

inline NormalizedPoint MaskGeometry::left_border(int x, int y) const {
  if (left_borders_.empty()) return without_lens(x - 0.5, y);
  const Eigen::Vector2f& at = left_borders_[index(x, y)];
  return {at.x(), at.y()};
}

inline NormalizedPoint MaskGeometry::top_border(int x, int y) const {
  if (top_borders_.empty()) return without_lens(x, y - 0.5);
  const Eigen::Vector2f& at = top_borders_[index(x, y)];
  return {at.x(), at.y()};
}

}  // namespace lineservo::features
