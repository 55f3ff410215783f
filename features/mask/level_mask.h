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

}  // namespace lineservo::features
