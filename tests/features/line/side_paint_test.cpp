#include "features/line/side_paint.h"

#include <gtest/gtest.h>

#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

using test::blot;
using test::draw;
using test::Floor;
using test::kAhead;
using test::kBehind;
using test::kLeft;
using test::kRight;
using test::node_floor;
using test::Pose;
using test::TestMask;
using test::TestRandom;

constexpr double kWidth_m = 0.36, kHeight_m = 0.5;

class SidePaintTest : public testing::Test {
 protected:
  /// Beside the stripe along the vehicle's heading, which is in view from end to end.
  std::vector<SidePaint> see(const TestMask& mask) {
    const LevelMask level(mask.view(), geometry_, LevelView());
    Stripe stripe;
    stripe.course = {0.0, 0.0, kWidth_m / kHeight_m};
    stripe.begin.along = -0.74;
    stripe.end.along = 0.74;
    return side_paint(level, stripe, [this](const Eigen::Vector2d& p_L) { return is_known_(p_L); });
  }
  TestMask mask_of(const std::vector<double>& arms, double x_m) {
    return draw(geometry_, Pose{.x_m = x_m}, node_floor(arms, kWidth_m));
  }

  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
  std::function<bool(const Eigen::Vector2d&)> is_known_ = [](const Eigen::Vector2d&) { return false; };
};

TEST_F(SidePaintTest, AnArmIsFoundOnItsSideAndInItsPlace) {
  for (const double ahead_m : {-0.2, -0.1, 0.0, 0.15, 0.25}) {
    // Left is −x of L, away from the normal.
    for (const auto& [heading, side] : {std::pair{kLeft, -1.0}, {kRight, 1.0}}) {
      const auto found = see(mask_of({kAhead, kBehind, heading}, -ahead_m));
      ASSERT_EQ(found.size(), 1u) << ahead_m;
      EXPECT_EQ(found[0].side, side);
      EXPECT_NEAR(found[0].along, ahead_m / kHeight_m, 0.04) << ahead_m;
      EXPECT_GT(found[0].away, 0.5 * kWidth_m / kHeight_m);
    }
  }
}

TEST_F(SidePaintTest, WornPaintIsAreaEnough) {
  TestRandom random(3);
  for (int k = 0; k < 40; ++k) {
    TestMask mask = mask_of({kAhead, kBehind, kLeft, kRight}, random.uniform(-0.2, 0.2));
    blot(mask, random, 0.25, 12.0, false);
    EXPECT_EQ(see(mask).size(), 2u) << k;
  }
}

TEST_F(SidePaintTest, BareFloorAndWhatIsKnownAreNoArm) {
  EXPECT_TRUE(see(mask_of({kAhead, kBehind}, 0.0)).empty());
  is_known_ = [](const Eigen::Vector2d&) { return true; };
  EXPECT_TRUE(see(mask_of({kAhead, kBehind, kLeft}, 0.0)).empty());
}

// All floor beside the stripe is painted: that is no arm of the stripe's width.
TEST_F(SidePaintTest, PaintWithoutEndIsNoArm) {
  Floor floor = node_floor({kAhead, kBehind}, kWidth_m);
  floor.strips.push_back({{-5.0, 0.6}, {5.0, 0.6}, 0.9});
  EXPECT_TRUE(see(draw(geometry_, Pose{}, floor)).empty());
}

}  // namespace
}  // namespace lineservo::features
