#include "features/mask/mask_geometry.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lineservo::features {
namespace {

TEST(MaskGeometry, KeepsThePixelCentresOfTheResize) {
  const CameraModel camera{CameraParameters{}};
  const MaskGeometry geometry(camera, 400, 400);
  // Mask column 0 covers frame columns −0.5 … 1.1, centre 0.3; row 0 covers −0.5 … 0.7, centre 0.1.
  const NormalizedPoint corner = geometry.normalize({0.0, 0.0});
  EXPECT_NEAR(corner.x, (0.3 - 319.5) / 320.0, 1e-15);
  EXPECT_NEAR(corner.y, (0.1 - 239.5) / 320.0, 1e-15);
  const NormalizedPoint centre = geometry.normalize({199.5, 199.5});
  EXPECT_NEAR(centre.x, 0.0, 1e-15);
  EXPECT_NEAR(centre.y, 0.0, 1e-15);
}

TEST(MaskGeometry, PinholeAndLookUpAgreeWithTheCamera) {
  CameraParameters bent;
  bent.distortion = {-0.1, 0.02, 1e-3, -5e-4, 0.0};
  for (const CameraParameters& parameters : {CameraParameters{}, bent}) {
    const MaskGeometry geometry(CameraModel{parameters}, 400, 400);
    for (const int at : {1, 57, 200, 399}) {
      const NormalizedPoint left = geometry.left_border(at, 120), top = geometry.top_border(120, at);
      const NormalizedPoint left_truth = geometry.normalize({at - 0.5, 120.0});
      const NormalizedPoint top_truth = geometry.normalize({120.0, at - 0.5});
      EXPECT_NEAR(left.x, left_truth.x, 1e-6);
      EXPECT_NEAR(left.y, left_truth.y, 1e-6);
      EXPECT_NEAR(top.x, top_truth.x, 1e-6);
      EXPECT_NEAR(top.y, top_truth.y, 1e-6);
      const PixelPoint back = geometry.project(left_truth);
      EXPECT_NEAR(back.x, at - 0.5, 1e-8);
      EXPECT_NEAR(back.y, 120.0, 1e-8);
    }
  }
}

TEST(MaskGeometry, RefusesSizesOutOfBounds) {
  const CameraModel camera{CameraParameters{}};
  EXPECT_THROW(MaskGeometry(camera, 15, 400), std::invalid_argument);
  EXPECT_THROW(MaskGeometry(camera, 400, 4097), std::invalid_argument);
  EXPECT_NO_THROW(MaskGeometry(camera, 16, 16));
}

}  // namespace
}  // namespace lineservo::features
