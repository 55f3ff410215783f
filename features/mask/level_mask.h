#pragma once

#include <Eigen/Core>

#include "features/geometry/level_view.h"
#include "features/geometry/points.h"
#include "features/mask/mask_geometry.h"
#include "features/mask/mask_view.h"

namespace lineservo::features {

/// What a mask says of a place on the floor.
enum class Paint { out_of_view, bare, painted };

/// A mask looked at through the virtual level camera. Borrows mask and geometry; cheap to make.
class LevelMask {
 public:
  LevelMask(const MaskView& mask, const MaskGeometry& geometry, const LevelView& view);

  const MaskView& mask() const { return mask_; }
  const MaskGeometry& geometry() const { return geometry_; }

  /// The level point of an undistorted point of the camera.
  Eigen::Vector2d level(NormalizedPoint point) const {
    const Eigen::Matrix3d& R = view_.R_LC();
    const double z = 1.0 / (R(2, 0) * point.x + R(2, 1) * point.y + R(2, 2));
    return {(R(0, 0) * point.x + R(0, 1) * point.y + R(0, 2)) * z,
            (R(1, 0) * point.x + R(1, 1) * point.y + R(1, 2)) * z};
  }
  /// Where a level point lies in the mask, in mask pixels; may lie out of view.
  PixelPoint project(const Eigen::Vector2d& p_L) const;
  Paint at(const Eigen::Vector2d& p_L) const;

 private:
  MaskView mask_;
  const MaskGeometry& geometry_;
  LevelView view_;
  Eigen::Matrix3d mask_H_L_;  ///< homography from L to mask pixels, of the pinhole part
};

inline PixelPoint LevelMask::project(const Eigen::Vector2d& p_L) const {
  if (geometry_.has_distortion()) return geometry_.project(view_.tilted({p_L.x(), p_L.y()}));
  const Eigen::Matrix3d& H = mask_H_L_;
  const double z = 1.0 / (H(2, 0) * p_L.x() + H(2, 1) * p_L.y() + H(2, 2));
  return {(H(0, 0) * p_L.x() + H(0, 1) * p_L.y() + H(0, 2)) * z,
          (H(1, 0) * p_L.x() + H(1, 1) * p_L.y() + H(1, 2)) * z};
}

inline Paint LevelMask::at(const Eigen::Vector2d& p_L) const {
  const PixelPoint px = project(p_L);
  // Written so that a point at infinity or NaN is out of view.
  if (!(px.x > -0.5 && px.x < mask_.width - 0.5 && px.y > -0.5 && px.y < mask_.height - 0.5))
    return Paint::out_of_view;
  return mask_.at(static_cast<int>(px.x + 0.5), static_cast<int>(px.y + 0.5)) ? Paint::painted : Paint::bare;
}

}  // namespace lineservo::features
