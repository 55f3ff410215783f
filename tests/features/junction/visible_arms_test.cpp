#include "features/junction/visible_arms.h"

#include <gtest/gtest.h>

#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

class VisibleArms : public testing::Test {
 protected:
  JunctionArm arm(double angle_rad, double width) const {
    return {.feature = {.angle_rad = angle_rad, .length = 2.0}, .width = width, .leaves_view = true};
  }

  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
  test::TestMask mask_{test::kMaskSize, test::kMaskSize};
  LevelMask level_{mask_.view(), geometry_, LevelView{}};
};

// A mask pixel is 1.6 px / 320 px = 0.005 wide and 1.2 / 320 = 0.00375 high; the view ends at y = ∓0.75.
TEST_F(VisibleArms, SizeIsThatOfTheRectangleBeyondTheNodesSquare) {
  const Eigen::Vector2d size = visible_arm_size_px(level_, {0.0, 0.0}, arm(0.0, 0.4));
  EXPECT_NEAR(size.x(), 0.4 / 0.005, 1e-9);
  EXPECT_NEAR(size.y(), (0.75 - 0.2) / 0.00375, 1e-9);
}

TEST_F(VisibleArms, AnEndWithinTheViewBoundsIt) {
  const JunctionArm stub{
      .feature = {.angle_rad = test::kLeft, .length = 0.3}, .width = 0.2, .leaves_view = false};
  const Eigen::Vector2d size = visible_arm_size_px(level_, {0.1, 0.0}, stub);
  EXPECT_NEAR(size.x(), 0.3 / 0.005, 1e-9);
  EXPECT_NEAR(size.y(), 0.2 / 0.00375, 1e-9);
}

TEST_F(VisibleArms, AnArmCountsFromTwentyPixelsOn) {
  const double height = 0.00375;
  // A branch of width 0.4 that runs to the left; its near border lies 19.9 or 20.1 px below the image's top.
  for (const double rows : {19.9, 20.1}) {
    const LevelPoint centre{0.0, -0.75 + rows * height - 0.2};
    EXPECT_EQ(visible_arms(level_, centre, {arm(test::kLeft, 0.4)}, {.across_slack_px = 0.0}).left,
              rows > 20.0);
  }
}

TEST_F(VisibleArms, TheSlackActsAcrossTheArmAlone) {
  const double width = 18.0 * 0.005;
  EXPECT_TRUE(visible_arms(level_, {0.0, 0.0}, {arm(0.0, width)}).forward);
  EXPECT_FALSE(visible_arms(level_, {0.0, 0.0}, {arm(0.0, width)}, {.across_slack_px = 0.0}).forward);
  EXPECT_FALSE(visible_arms(level_, {0.0, 0.0}, {arm(0.0, 16.0 * 0.005)}).forward);
  const double y = -0.75 + 18.0 * 0.00375 + 0.5 * 0.4;  // 18 px of the forward arm lie in view
  EXPECT_FALSE(visible_arms(level_, {0.0, y}, {arm(0.0, 0.4)}).forward);
}

TEST_F(VisibleArms, DirectionsWithin25DegreesOfAnAxis) {
  const auto seen = [this](double deg) { return visible_arms(level_, {0.0, 0.0}, {arm(radians(deg), 0.3)}); };
  EXPECT_EQ(seen(24.0), (Arms{.forward = true}));
  EXPECT_EQ(seen(26.0), Arms{});
  EXPECT_EQ(seen(66.0), (Arms{.left = true}));
  EXPECT_EQ(seen(-114.0), (Arms{.right = true}));
  EXPECT_EQ(seen(156.0), (Arms{.back = true}));
  EXPECT_EQ(seen(-156.0), (Arms{.back = true}));
  EXPECT_EQ(seen(135.0), Arms{});
}

}  // namespace
}  // namespace lineservo::features
