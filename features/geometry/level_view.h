#pragma once

#include <Eigen/Core>

#include "features/geometry/points.h"

namespace lineservo::features {

/// Rotation of the down-looking camera in the body: x_C = −y_B, y_C = −x_B, z_C = −z_B.
Eigen::Matrix3d down_camera_R_BC();

/// Rotation of the body B in the heading frame H (z up, x the horizontal projection of x_B): R_HB =
/// R_y(pitch) R_x(roll).
Eigen::Matrix3d tilt_R_HB(double roll_rad, double pitch_rad);

/// Maps between the camera C and the virtual level camera L, which is C with roll and pitch taken out.
class LevelView {
 public:
  /// No tilt: C and L are the same.
  LevelView() : R_LC_(Eigen::Matrix3d::Identity()) {}
  /// From the attitude estimate, for a camera mounted as down_camera_R_BC().
  LevelView(double roll_rad, double pitch_rad);

  /// A point of C seen in L. The ray must meet the floor ahead of L (tilt plus half the field of view below
  /// 90°).
  LevelPoint level(NormalizedPoint point) const;
  /// The inverse of level().
  NormalizedPoint tilted(LevelPoint point) const;

  const Eigen::Matrix3d& R_LC() const { return R_LC_; }

 private:
  Eigen::Matrix3d R_LC_;
};

}  // namespace lineservo::features
