#include "features/geometry/level_view.h"

#include <Eigen/Geometry>

namespace lineservo::features {

Eigen::Matrix3d down_camera_R_BC() {
  Eigen::Matrix3d R_BC;
  R_BC << 0, -1, 0,  //
      -1, 0, 0,      //
      0, 0, -1;
  return R_BC;
}

Eigen::Matrix3d tilt_R_HB(double roll_rad, double pitch_rad) {
  return (Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

// The level camera is mounted in H as the camera is in B, so R_LC = R_BCᵀ R_HB R_BC.
LevelView::LevelView(double roll_rad, double pitch_rad) {
  const Eigen::Matrix3d R_BC = down_camera_R_BC();
  R_LC_ = R_BC.transpose() * tilt_R_HB(roll_rad, pitch_rad) * R_BC;
}

LevelPoint LevelView::level(NormalizedPoint point) const {
  const Eigen::Vector3d ray = R_LC_ * Eigen::Vector3d(point.x, point.y, 1.0);
  return {ray.x() / ray.z(), ray.y() / ray.z()};
}

NormalizedPoint LevelView::tilted(LevelPoint point) const {
  const Eigen::Vector3d ray = R_LC_.transpose() * Eigen::Vector3d(point.x, point.y, 1.0);
  return {ray.x() / ray.z(), ray.y() / ray.z()};
}

}  // namespace lineservo::features
