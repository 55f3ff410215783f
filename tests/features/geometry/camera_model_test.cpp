#include "features/geometry/camera_model.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lineservo::features {
namespace {

CameraParameters distorted() {
  CameraParameters p;
  p.distortion = {-0.25, 0.08, 0.001, -0.0007, -0.01};
  return p;
}

TEST(CameraModel, DefaultIsTheTopologyCamera) {
  const CameraModel camera{CameraParameters{}};
  const NormalizedPoint corner = camera.normalize({-0.5, -0.5});
  EXPECT_DOUBLE_EQ(corner.x, -1.0);  // 320 px of half width over f = 320 px
  EXPECT_DOUBLE_EQ(corner.y, -0.75);
}

TEST(CameraModel, NormalizeInvertsProjectAcrossTheWholeImage) {
  const CameraModel camera{distorted()};
  for (double y = 0; y < 480; y += 37) {
    for (double x = 0; x < 640; x += 41) {
      const PixelPoint back = camera.project(camera.normalize({x, y}));
      EXPECT_NEAR(back.x, x, 1e-9);
      EXPECT_NEAR(back.y, y, 1e-9);
    }
  }
}

TEST(CameraModel, RefusesALensThatFoldsTheCorners) {
  CameraParameters folding;  // r (1 − 0.3 r²) turns back at r = 1.05, inside the corners at 1.25
  folding.distortion = {-0.3, 0.0, 0.0, 0.0, 0.0};
  EXPECT_THROW(CameraModel{folding}, std::invalid_argument);
  folding.distortion[1] = 0.1;
  EXPECT_NO_THROW(CameraModel{folding});
}

// r (1 + k1 r²) turns back at r' = 2/3 / √(−3 k1), which is the corner's 1.25 at k1 = −0.0948. Beyond it the
// inverse may still find a ray of the corner's pixel, on the other side of the fold.
TEST(CameraModel, RefusesALensFromWhereItFoldsOn) {
  for (double k1 = -0.08; k1 > -0.5; k1 -= 0.001) {
    CameraParameters p;
    p.distortion[0] = k1;
    if (k1 > -0.0945) {
      EXPECT_NO_THROW(CameraModel{p}) << k1;
    } else if (k1 < -0.095) {
      EXPECT_THROW(CameraModel{p}, std::invalid_argument) << k1;
    }
  }
}

TEST(CameraModel, RefusesEveryBadValueAtOnce) {
  CameraParameters p;
  p.width_px = 0;
  p.fx_px = -1.0;
  try {
    CameraModel{p};
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "camera: width must be 16 to 16384 px; fx must be positive");
  }
}

}  // namespace
}  // namespace lineservo::features
