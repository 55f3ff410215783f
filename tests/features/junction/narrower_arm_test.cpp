#include "features/junction/narrower_arm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

using test::Pose;
using test::Strip;

constexpr double kWide_m = 0.36, kHeight_m = 0.5;
constexpr double kPixel = 0.006;  // of the mask across, normalised

/// A wide stripe that comes from behind and ends at the origin, and what lies beyond it.
class NarrowerArmTest : public testing::Test {
 protected:
  std::optional<NarrowerArm> look(std::vector<Strip> beyond, const Pose& pose = {}) {
    draw(std::move(beyond), pose);
    const StripeCourse course = test::true_course(pose, {0.0, 0.0}, 0.0, kWide_m);
    const double end_along = StripeAxes(course).along(pose.level({0.0, 0.0}));
    return narrower_arm(level(pose), course, end_along, +1);
  }
  void draw(std::vector<Strip> strips, const Pose& pose) {
    strips.push_back({{-5.0, 0.0}, {0.0, 0.0}, kWide_m});
    mask_ = test::draw(geometry_, pose, {.strips = strips, .arm_headings_rad = {}});
  }
  LevelMask level(const Pose& pose) const { return {mask_->view(), geometry_, pose.view()}; }

  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
  std::optional<test::TestMask> mask_;
};

TEST_F(NarrowerArmTest, NothingGoesOnAtADeadEnd) {
  EXPECT_FALSE(look({}).has_value());
}

TEST_F(NarrowerArmTest, MeasuresTheWidthAndTheEndOfALineThatGoesOn) {
  for (const double width_m : {0.05, 0.1, 0.2}) {
    for (const double length_m : {0.1, 0.2}) {
      for (const double heading_rad : {-0.1, 0.0, 0.07}) {
        const Pose pose{.height_m = kHeight_m, .heading_rad = heading_rad};
        const auto arm = look({{{-0.1, 0.0}, {length_m, 0.0}, width_m}}, pose);
        ASSERT_TRUE(arm.has_value()) << width_m << ' ' << length_m << ' ' << heading_rad;
        EXPECT_NEAR(arm->width, width_m / kHeight_m, 3.0 * kPixel);
        EXPECT_NEAR(arm->end.along, length_m / kHeight_m, 3.0 * kPixel);
        EXPECT_FALSE(arm->end.leaves_view);
      }
    }
  }
}

TEST_F(NarrowerArmTest, ALineMayLeaveTheView) {
  const auto arm = look({{{-0.1, 0.0}, {3.0, 0.0}, 0.1}});
  ASSERT_TRUE(arm.has_value());
  EXPECT_TRUE(arm->end.leaves_view);
  EXPECT_NEAR(arm->end.along, 0.75, 3.0 * kPixel);  // the border of the image
}

// Forward and back are the same but for the sign.
TEST_F(NarrowerArmTest, LooksBackAsItLooksAhead) {
  draw({}, {});
  mask_ = test::draw(geometry_, {},
                     {.strips = {{{0.0, 0.0}, {5.0, 0.0}, kWide_m}, {{-0.2, 0.0}, {0.1, 0.0}, 0.1}},
                      .arm_headings_rad = {}});
  const StripeCourse course{0.0, 0.0, kWide_m / kHeight_m};
  const auto back = narrower_arm(level({}), course, 0.0, -1);
  ASSERT_TRUE(back.has_value());
  EXPECT_NEAR(back->width, 0.2, 3.0 * kPixel);
  EXPECT_NEAR(back->end.along, -0.4, 3.0 * kPixel);
}

TEST_F(NarrowerArmTest, TheStripeItselfIsNotNarrower) {
  EXPECT_FALSE(look({{{-0.1, 0.0}, {3.0, 0.0}, kWide_m}}).has_value());
  EXPECT_FALSE(look({{{-0.1, 0.0}, {3.0, 0.0}, 0.95 * kWide_m}}).has_value());
}

TEST_F(NarrowerArmTest, AThreadIsNoLine) {
  EXPECT_FALSE(look({{{-0.1, 0.0}, {3.0, 0.0}, 0.006}}).has_value());
}

// A blot has no one width, and a line beside the centreline is another line.
TEST_F(NarrowerArmTest, WantsOneWidthAboutTheCentreline) {
  EXPECT_FALSE(look({{{-0.1, 0.0}, {0.0125, 0.0}, 0.05}, {{0.0125, 0.0}, {0.1, 0.0}, 0.2}}).has_value());
  EXPECT_FALSE(look({{{-0.1, 0.1}, {3.0, 0.1}, 0.05}}).has_value());
}

TEST_F(NarrowerArmTest, OutOfViewTellsNothing) {
  const Pose pose{.x_m = -0.37};  // the end lies 5 mm within the image's border
  EXPECT_FALSE(look({{{-0.1, 0.0}, {3.0, 0.0}, 0.1}}, pose).has_value());
}

TEST_F(NarrowerArmTest, PaintReachesHalfAStripesWidthToEitherSide) {
  draw({}, {});
  const StripeAxes axes({0.0, 0.0, kWide_m / kHeight_m});
  for (const double side : {-1.0, 1.0}) {
    const auto reach = painted_to(level({}), axes, -0.3, side, 0.6);
    ASSERT_TRUE(reach.has_value());
    EXPECT_NEAR(*reach, 0.36, 2.0 * kPixel);
    EXPECT_NEAR(*painted_to(level({}), axes, -0.3, side, 0.2), 0.2, kPixel) << "the bound";
    EXPECT_EQ(*painted_to(level({}), axes, 0.3, side, 0.6), 0.0) << "bare floor";
    EXPECT_FALSE(painted_to(level({}), axes, -2.0, side, 0.6).has_value()) << "out of view";
  }
}

}  // namespace
}  // namespace lineservo::features
