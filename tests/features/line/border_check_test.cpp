#include "features/line/border_check.h"

#include <gtest/gtest.h>

#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

using test::draw;
using test::Floor;
using test::kAhead;
using test::kBehind;
using test::kLeft;
using test::kRight;
using test::node_floor;
using test::Pose;
using test::straight_floor;
using test::TestMask;
using test::TestRandom;

constexpr double kWidth_m = 0.06, kHeight_m = 0.5;
constexpr double kWidth = kWidth_m / kHeight_m;

class BorderCheckTest : public testing::Test {
 protected:
  BorderCount count(const TestMask& mask, const StripeCourse& course, double side,
                    const std::function<bool(const Eigen::Vector2d&)>& is_known) {
    return BorderCheck().count(LevelMask(mask.view(), geometry_, LevelView()), course, {-0.6, 0.6, side},
                               is_known);
  }
  BorderCount count(const TestMask& mask, const StripeCourse& course = {0.0, 0.0, kWidth}) {
    return count(mask, course, 1.0, [](const Eigen::Vector2d&) { return false; });
  }
  TestMask mask_of(const Floor& floor) { return draw(geometry_, Pose{}, floor); }
  /// A disc on the floor around the vehicle.
  TestMask with_disc(TestMask mask, double radius_m) {
    test::for_each_pixel(geometry_, Pose{}, [&](int x, int y, const Eigen::Vector2d& p) {
      if (p.norm() < radius_m) mask.set(x, y, true);
    });
    return mask;
  }

  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
};

TEST_F(BorderCheckTest, AStraightLineHasBareFloorAllAlong) {
  const BorderCount found = count(mask_of(straight_floor(kWidth_m)));
  EXPECT_GT(found.edges, 50);
  EXPECT_EQ(found.paint_beyond, 0);
  EXPECT_TRUE(found.is_border_of_first());
  EXPECT_TRUE(found.is_border());
}

TEST_F(BorderCheckTest, ACrossingCoversNoMoreThanItsWidth) {
  const BorderCount found = count(mask_of(node_floor({kAhead, kBehind, kLeft, kRight}, kWidth_m)));
  EXPECT_NEAR(0.02 * found.paint_beyond, kWidth, 0.041);
  EXPECT_EQ(found.covered, found.paint_beyond);  // the cross is painted on both sides
  EXPECT_NEAR(found.crossed_paint, found.paint_beyond, 1);
  EXPECT_TRUE(found.is_border_of_first());
}

TEST_F(BorderCheckTest, ADiscCoversBothBorders) {
  const BorderCount found = count(with_disc(mask_of(straight_floor(kWidth_m)), 0.14));
  EXPECT_LT(found.edges, 0.8 * (found.edges + found.paint_beyond));
  EXPECT_EQ(found.covered, found.paint_beyond);
  EXPECT_TRUE(found.is_border_of_first());
  EXPECT_TRUE(found.is_border());
}

TEST_F(BorderCheckTest, InsidePaintThereIsNoBorder) {
  Floor floor = straight_floor(5.0 * kWidth_m);
  const BorderCount clean = count(mask_of(floor));
  EXPECT_EQ(clean.edges, 0);
  EXPECT_FALSE(clean.is_border_of_first());
  TestRandom random(4);
  for (int k = 0; k < 40; ++k) {
    TestMask worn = mask_of(floor);
    test::blot(worn, random, 0.25, 12.0, false);
    EXPECT_FALSE(count(worn).is_border_of_first()) << k;
  }
}

TEST_F(BorderCheckTest, PaintBesideOneBorderOnlyIsNoDisc) {
  Floor floor = straight_floor(kWidth_m);
  floor.strips.push_back({{-0.2, -0.06}, {0.2, -0.06}, 0.06});  // along the right border, which is +x of L
  const BorderCount found = count(mask_of(floor));
  EXPECT_GT(found.paint_beyond, 20);
  EXPECT_EQ(found.covered, 0);
  EXPECT_FALSE(found.is_border_of_first());
  EXPECT_FALSE(found.is_border());
}

TEST_F(BorderCheckTest, WhatIsKnownSaysNothing) {
  const BorderCount found = count(mask_of(straight_floor(kWidth_m)), {0.0, 0.0, kWidth}, -1.0,
                                  [](const Eigen::Vector2d&) { return true; });
  EXPECT_EQ(found.edges + found.paint_beyond, 0);
}

}  // namespace
}  // namespace lineservo::features
