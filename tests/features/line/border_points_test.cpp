#include "features/line/border_points.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

using test::draw;
using test::Pose;
using test::straight_floor;
using test::TestMask;

class BorderPoints : public testing::Test {
 protected:
  std::vector<BorderPoint> of(const TestMask& mask, const LevelView& view = {}) {
    std::vector<BorderPoint> points;
    extractor_.extract(LevelMask(mask.view(), geometry_, view), points);
    return points;
  }

  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
  BorderExtractor extractor_;
};

TEST_F(BorderPoints, LieOnTheStripesBordersAndLookIntoIt) {
  const Pose pose{.y_m = 0.05, .heading_rad = 0.3, .roll_rad = 0.06, .pitch_rad = -0.05};
  const std::vector<BorderPoint> points = of(draw(geometry_, pose, straight_floor(0.36)), pose.view());
  ASSERT_GT(points.size(), 150u);
  const StripeAxes axes(test::true_course(pose, {0.0, 0.0}, 0.0, 0.36));
  for (const BorderPoint& point : points) {
    const double across = axes.across(point.p_L);
    EXPECT_NEAR(std::abs(across), 0.36, 0.005);  // half of 0.36 m / 0.5 m, to a pixel
    const double inward = across > 0.0 ? -1.0 : 1.0;
    EXPECT_GT(point.normal.dot(axes.normal()) * inward, std::cos(radians(10.0)));
  }
}

TEST_F(BorderPoints, StandForTheLengthOfTheBorderAtAnyAngle) {
  for (const double heading : {0.0, 0.3, radians(45.0), radians(70.0), radians(90.0)}) {
    const Pose pose{.height_m = 1.0, .heading_rad = heading};
    // A bar of 0.8 m × 0.1 m, all in view: its two long borders measure 1.6.
    const test::Floor bar{.strips = {{{-0.4, 0.0}, {0.4, 0.0}, 0.1}}, .arm_headings_rad = {}};
    const StripeAxes axes(test::true_course(pose, {0.0, 0.0}, 0.0, 0.1));
    double length = 0.0;
    for (const BorderPoint& point : of(draw(geometry_, pose, bar)))
      if (std::abs(point.normal.dot(axes.normal())) > 0.9) length += point.length;
    EXPECT_NEAR(length, heading == radians(45.0) ? 1.5 : 1.6, 0.25) << degrees(heading);
  }
}

TEST_F(BorderPoints, TheFrameOfTheImageIsNoBorder) {
  TestMask full(test::kMaskSize, test::kMaskSize);
  EXPECT_TRUE(of(full).empty());
  for (int y = 0; y < test::kMaskSize; ++y)
    for (int x = 0; x < test::kMaskSize; ++x) full.set(x, y, true);
  EXPECT_TRUE(of(full).empty());
}

TEST_F(BorderPoints, ScanLinesFullOfNoiseAreLeftOut) {
  TestMask mask(test::kMaskSize, test::kMaskSize);
  test::TestRandom random(3);
  test::add_noise(mask, random, 0.5);
  EXPECT_TRUE(of(mask).empty());
}

TEST(BorderOptions, AreChecked) {
  EXPECT_THROW(BorderExtractor({.stride_px = 3}), std::invalid_argument);
  EXPECT_THROW(BorderExtractor({.max_crossings_a_line = 1}), std::invalid_argument);
  EXPECT_THROW(BorderExtractor({.min_links = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
