#include "features/geometry/level_view.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>

namespace lineservo::features {
namespace {

TEST(LevelView, ForwardOfTheVehicleIsUpInTheImage) {
  const Eigen::Matrix3d R_BC = down_camera_R_BC();
  EXPECT_TRUE((R_BC.transpose() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY()));
  EXPECT_TRUE((R_BC.transpose() * Eigen::Vector3d::UnitY()).isApprox(-Eigen::Vector3d::UnitX()));
  EXPECT_NEAR(R_BC.determinant(), 1.0, 1e-15);
}

TEST(LevelView, NoseDownShowsTheFloorBelowFurtherUp) {
  // Pitch > 0 is nose down in a z-up body: the camera looks backward, so its axis meets the floor behind (y_L
  // > 0).
  const LevelPoint below = LevelView(0.0, 0.1).level({0.0, 0.0});
  EXPECT_NEAR(below.y, std::tan(0.1), 1e-12);
  EXPECT_NEAR(below.x, 0.0, 1e-12);
}

TEST(LevelView, TiltedInvertsLevel) {
  const LevelView view(0.07, -0.12);
  const LevelPoint level = view.level({0.3, -0.6});
  const NormalizedPoint back = view.tilted(level);
  EXPECT_NEAR(back.x, 0.3, 1e-12);
  EXPECT_NEAR(back.y, -0.6, 1e-12);
}

}  // namespace
}  // namespace lineservo::features
