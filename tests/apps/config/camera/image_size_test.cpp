#include "apps/config/camera/image_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using testing::complaint;
using ::testing::HasSubstr;

const features::CameraParameters kCamera{.width_px = 640,
                                         .height_px = 480,
                                         .fx_px = 400.0,
                                         .fy_px = 402.0,
                                         .cx_px = 320.0,
                                         .cy_px = 238.0,
                                         .distortion = {-0.1, 0.01, 0.0, 0.0, 0.0}};

TEST(ImageSize, TheSameSizeIsTheSameCamera) {
  EXPECT_EQ(camera_for_size(kCamera, 640, 480).fx_px, 400.0);
  EXPECT_EQ(camera_for_size(kCamera, 640, 480, OtherSize::scale).cx_px, 320.0);
}

TEST(ImageSize, AnotherSizeIsRefusedUnlessScalingIsAskedFor) {
  EXPECT_THAT(complaint([] { camera_for_size(kCamera, 320, 240); }),
              HasSubstr("the image is 320×240 px, the camera 640×480"));
}

// A ray meets the same place of the picture: pixel centres are whole numbers, so its left border is −½.
TEST(ImageSize, ScaledARayMeetsTheSamePlaceOfThePicture) {
  const auto half = camera_for_size(kCamera, 320, 240, OtherSize::scale);
  const features::NormalizedPoint ray{0.3, -0.2};
  const auto full_px = features::CameraModel(kCamera).project(ray);
  const auto half_px = features::CameraModel(half).project(ray);
  EXPECT_NEAR((half_px.x + 0.5) / 320.0, (full_px.x + 0.5) / 640.0, 1e-12);
  EXPECT_NEAR((half_px.y + 0.5) / 240.0, (full_px.y + 0.5) / 480.0, 1e-12);
}

TEST(ImageSize, ARoundedSideIsTheSameViewAnotherRatioIsNot) {
  EXPECT_EQ(camera_for_size({.width_px = 1920, .height_px = 1080}, 427, 240, OtherSize::scale).width_px, 427);
  EXPECT_THAT(complaint([] { camera_for_size(kCamera, 640, 360, OtherSize::scale); }),
              HasSubstr("sides of another ratio"));
}

}  // namespace
}  // namespace lineservo::apps
