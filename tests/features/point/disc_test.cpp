#include "features/point/disc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::features {
namespace {

PackedMask disc(int width, int height, int cx, int cy, int radius) {
  PackedMask mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius) mask.set(x, y);
  return mask;
}

TEST(StartDisc, NeedsMoreThanTheLimit) {
  PackedMask marker(100, 60);
  for (int k = 0; k < 350; ++k) marker.set(20 + k % 50, 10 + k / 50);  // 7 rows of 50
  EXPECT_FALSE(start_disc(marker));
  for (int x = 20; x < 70; ++x) marker.set(x, 17);
  const auto centre = start_disc(marker);
  ASSERT_TRUE(centre);
  EXPECT_DOUBLE_EQ(centre->x, 44.5);
  EXPECT_DOUBLE_EQ(centre->y, 13.5);
}

TEST(EndDisc, SurvivesWhenAsLargeAsTheKernel) {
  const auto exact = end_disc(disc(160, 120, 70, 50, 11), 11);
  ASSERT_TRUE(exact);
  EXPECT_DOUBLE_EQ(exact->x, 70.0);
  EXPECT_DOUBLE_EQ(exact->y, 50.0);
  EXPECT_FALSE(end_disc(disc(160, 120, 70, 50, 10), 11));
}

TEST(EndDisc, IsFoundAtTheEndOfItsStripe) {
  PackedMask mask = disc(160, 120, 80, 40, 13);
  for (int y = 40; y < 120; ++y)
    for (int x = 74; x <= 86; ++x) mask.set(x, y);  // 13 px, narrower than the kernel's 23
  const auto centre = end_disc(mask, 11);
  ASSERT_TRUE(centre);
  EXPECT_DOUBLE_EQ(centre->x, 80.0);
  EXPECT_NEAR(centre->y, 40.0, 1.0);
}

TEST(EndDisc, AStripeAloneIsNone) {
  PackedMask mask(160, 120);
  for (int y = 0; y < 120; ++y)
    for (int x = 70; x < 92; ++x) mask.set(x, y);  // 22 px, one short of the kernel
  EXPECT_FALSE(end_disc(mask, 11));
  EXPECT_THROW(end_disc(mask, 0), std::invalid_argument);
}

// A mask of 400 × 400 of a camera of 4:3: 2.5 and 3.33 times the published frame.
TEST(EndDisc, IsFoundInAMaskOfAnySize) {
  PackedMask mask(400, 400);
  const auto stretched = [](int x, int y) {
    return std::hypot((x - 210) / 2.5, (y - 120) / (400.0 / 120.0));
  };
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x)
      if (stretched(x, y) <= 13.2 || (y > 120 && std::abs(x - 210) <= 16)) mask.set(x, y);
  CameraParameters vtp;  // 640 px wide, of the same view as its 160 px
  vtp.fx_px = vtp.fy_px = 4.0 * 145.0;
  const auto centre = end_disc_as_published(mask, CameraModel(vtp), 1.1);
  ASSERT_TRUE(centre);
  EXPECT_NEAR(centre->x, 210.0, 2.5);
  EXPECT_NEAR(centre->y, 120.0, 3.4);
}

// From lower down the line is as wide in the frame as the disc was: the erosion has to grow with it.
TEST(EndDisc, IsToldFromItsLineFromAnyHeight) {
  const double f_px = 145.0;
  CameraParameters vtp;
  vtp.width_px = 160;
  vtp.height_px = 120;
  vtp.fx_px = vtp.fy_px = f_px;
  for (const double height_m : {1.1, 0.8, 0.5}) {
    const auto metres = [&](int px, int centre_px) { return (px - centre_px) * height_m / f_px; };
    PackedMask mask(160, 120);
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const double x_m = metres(x, 80), y_m = metres(y, 60);
        if (std::hypot(x_m, y_m) <= 0.1 || (y_m > 0.0 && std::abs(x_m) <= 0.05)) mask.set(x, y);
      }
    const auto centre = end_disc_as_published(mask, CameraModel(vtp), height_m);
    ASSERT_TRUE(centre) << height_m;
    EXPECT_NEAR(centre->x, 80.0, 1.0) << height_m;
    EXPECT_NEAR(centre->y, 60.0, 1.0) << height_m;
  }
}

}  // namespace
}  // namespace lineservo::features
