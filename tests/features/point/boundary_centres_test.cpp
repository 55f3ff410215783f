#include "features/point/boundary_centres.h"

#include <gtest/gtest.h>

namespace lineservo::features {
namespace {

void paint(PackedMask& mask, int x0, int y0, int x1, int y1) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) mask.set(x, y);
}

TEST(BoundaryCentres, AStraightLineCrossesTopAndBottom) {
  PackedMask path(200, 150);
  paint(path, 90, 0, 110, 150);
  const BoundaryCentres centres = boundary_centres(path);
  ASSERT_TRUE(centres.ahead && centres.behind);
  EXPECT_DOUBLE_EQ(centres.ahead->x, 99.5);
  EXPECT_DOUBLE_EQ(centres.ahead->y, 9.5);
  EXPECT_DOUBLE_EQ(centres.behind->x, 99.5);
  EXPECT_DOUBLE_EQ(centres.behind->y, 139.5);
}

TEST(BoundaryCentres, AnLLeavesBesideAndBelow) {
  PackedMask path(200, 150);
  paint(path, 90, 60, 110, 150);
  paint(path, 0, 60, 90, 80);
  const BoundaryCentres centres = boundary_centres(path);
  ASSERT_TRUE(centres.ahead && centres.behind);
  EXPECT_DOUBLE_EQ(centres.ahead->x, 9.5);
  EXPECT_DOUBLE_EQ(centres.ahead->y, 69.5);
  EXPECT_DOUBLE_EQ(centres.behind->y, 139.5);
}

TEST(BoundaryCentres, AtACrossTopAndBottomCount) {
  PackedMask path(200, 150);
  paint(path, 90, 0, 110, 150);
  paint(path, 0, 60, 200, 80);
  const BoundaryCentres centres = boundary_centres(path);
  EXPECT_DOUBLE_EQ(centres.ahead->y, 9.5);
  EXPECT_DOUBLE_EQ(centres.behind->y, 139.5);
}

TEST(BoundaryCentres, ASinglePartIsAheadOrBehind) {
  PackedMask above(200, 150), below(200, 150);
  paint(above, 90, 0, 110, 60);
  paint(below, 90, 90, 110, 150);
  EXPECT_TRUE(boundary_centres(above).ahead);
  EXPECT_FALSE(boundary_centres(above).behind);
  EXPECT_FALSE(boundary_centres(below).ahead);
  EXPECT_TRUE(boundary_centres(below).behind);
}

TEST(BoundaryCentres, LeavesOutNoiseAndTheMiddle) {
  PackedMask path(200, 150);
  paint(path, 50, 50, 150, 100);  // in no band
  paint(path, 0, 0, 19, 1);       // 19 px
  EXPECT_FALSE(boundary_centres(path).ahead);
  path.set(19, 0);
  EXPECT_TRUE(boundary_centres(path).ahead);
}

TEST(BoundaryCentres, ABandOutsideTheImageIsRefused) {
  const PackedMask path(200, 150);
  EXPECT_THROW(boundary_centres(path, {.band_x_px = 0}), std::invalid_argument);
  EXPECT_THROW(boundary_centres(path, {.band_x_px = 101}), std::invalid_argument);
  EXPECT_THROW(boundary_centres(path, {.band_y_px = 0}), std::invalid_argument);
  EXPECT_THROW(boundary_centres(path, {.band_y_px = 76}), std::invalid_argument);
  EXPECT_NO_THROW(boundary_centres(path, {.band_x_px = 100, .band_y_px = 75}));
}

TEST(BoundaryCentres, TheBandsDifferAlongTheAxes) {
  PackedMask path(200, 150);
  paint(path, 90, 0, 110, 150);
  const BoundaryCentres centres = boundary_centres(path, {.band_x_px = 10, .band_y_px = 30});
  EXPECT_DOUBLE_EQ(centres.ahead->y, 14.5);
  EXPECT_DOUBLE_EQ(centres.behind->y, 134.5);
}

// 20 px of 640 are 12.5 of 400, 20 px of 480 are 16.7 of 400; an area scales with both.
TEST(BoundaryCentres, TheBandIsCarriedOverToAnUnevenMask) {
  const BoundaryOptions same = carried_over({}, 640, 480);
  EXPECT_EQ(same.band_x_px, 20);
  EXPECT_EQ(same.band_y_px, 20);
  EXPECT_EQ(same.least_pixels, 20);
  const BoundaryOptions resized = carried_over({}, 400, 400);
  EXPECT_EQ(resized.band_x_px, 13);
  EXPECT_EQ(resized.band_y_px, 17);
  EXPECT_EQ(resized.least_pixels, 10);
  EXPECT_EQ(carried_over({}, 16, 16).band_x_px, 1);
}

}  // namespace
}  // namespace lineservo::features
