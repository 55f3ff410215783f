#include "features/mask/level_mask.h"

namespace lineservo::features {

LevelMask::LevelMask(const MaskView& mask, const MaskGeometry& geometry, const LevelView& view)
    : mask_(mask),
      geometry_(geometry),
      view_(view),
      mask_H_L_(geometry.pinhole() * view.R_LC().transpose()) {}

PixelPoint LevelMask::project(const Eigen::Vector2d& p_L) const {
  if (geometry_.has_distortion()) return geometry_.project(view_.tilted({p_L.x(), p_L.y()}));
  const Eigen::Matrix3d& H = mask_H_L_;
  const double z = 1.0 / (H(2, 0) * p_L.x() + H(2, 1) * p_L.y() + H(2, 2));
  return {(H(0, 0) * p_L.x() + H(0, 1) * p_L.y() + H(0, 2)) * z,
          (H(1, 0) * p_L.x() + H(1, 1) * p_L.y() + H(1, 2)) * z};
}

Paint LevelMask::at(const Eigen::Vector2d& p_L) const {
  const PixelPoint px = project(p_L);
  // Written so that a point at infinity or NaN is out of view.
  if (!(px.x > -0.5 && px.x < mask_.width - 0.5 && px.y > -0.5 && px.y < mask_.height - 0.5))
    return Paint::out_of_view;
  return mask_.at(static_cast<int>(px.x + 0.5), static_cast<int>(px.y + 0.5)) ? Paint::painted : Paint::bare;
}

}  // namespace lineservo::features
