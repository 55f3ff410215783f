#include "features/point/target_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "features/geometry/angles.h"
#include "features/perception.h"
#include "tests/features/line/drawn_stripe.h"

namespace lineservo::features {
namespace {

using test::draw_image;

const cv::Size kSize(640, 480);
constexpr double kFocal_px = 320.0, kCx = 319.5, kCy = 239.5;

CameraModel camera(int width_px = 640, int height_px = 480, double focal_px = kFocal_px) {
  CameraParameters p;
  p.width_px = width_px;
  p.height_px = height_px;
  p.fx_px = p.fy_px = focal_px;
  p.cx_px = 0.5 * (width_px - 1);
  p.cy_px = 0.5 * (height_px - 1);
  return CameraModel(p);
}

/// A stripe across the whole picture, in normalised units.
cv::Mat stripe(double x, double width, double theta_rad = 0.0) {
  const double rho_px = (kCx + x * kFocal_px) * std::cos(theta_rad) + kCy * std::sin(theta_rad);
  return draw_image(kSize, {{rho_px, theta_rad, width * kFocal_px}});
}

TargetFinder finder(const TargetOptions& options = {}) {
  return TargetFinder(camera(), {}, {}, options);
}

TEST(TargetFinder, LiesOnTheStripeAtTheArcThatBelongsToItsWidth) {
  for (const double width : {0.1, 0.2, 0.5}) {
    for (const double x : {-0.03, 0.0, 0.03}) {
      const auto target = finder().find(stripe(x, width), width);
      ASSERT_TRUE(target) << width;
      EXPECT_NEAR(target->x, x,
                  1.0 / 80.0);  // a pixel of the frame of 160, whose eroded stripe has only three
      EXPECT_NEAR(std::hypot(target->x, target->y), 0.8 * width, 1.0 / 80.0);
      EXPECT_LT(target->y, 0.0);
    }
  }
}

TEST(TargetFinder, TheArcDoesNotShrinkBelowItsLeastRadius) {
  const auto target = finder({.least_arc_px = 27.5}).find(stripe(0.2, 0.1), 0.1);
  ASSERT_TRUE(target);
  EXPECT_NEAR(std::hypot(target->x, target->y), 27.5 / 80.0, 1.0 / 80.0);
  EXPECT_FALSE(finder().find(stripe(0.2, 0.1), 0.1));  // the small arc does not reach so far aside
}

TEST(TargetFinder, RemembersTheStripesWidth) {
  TargetFinder target = finder();
  EXPECT_FALSE(target.find(stripe(0.0, 0.2), std::nullopt));  // never seen
  EXPECT_TRUE(target.find(stripe(0.0, 0.2), 0.2));
  EXPECT_TRUE(target.find(stripe(0.0, 0.2), std::nullopt));
}

TEST(TargetFinder, FollowsALineThatTurnsInTheImageUntilItIsToldToForget) {
  // The line is turned by 150° in steps: the target stays on the same end, which then points backward.
  TargetFinder target = finder();
  std::optional<NormalizedPoint> at;
  for (int deg = 0; deg <= 150; deg += 10) at = target.find(stripe(0.0, 0.2, radians(deg)), 0.2);
  ASSERT_TRUE(at);
  EXPECT_GT(at->y, 0.1);
  target.forget_direction();
  at = target.find(stripe(0.0, 0.2, radians(150)), 0.2);
  ASSERT_TRUE(at);
  EXPECT_LT(at->y, -0.1);
}

TEST(TargetFinder, AFrameWithoutATargetKeepsTheDirection) {
  TargetFinder target = finder();
  for (int deg = 0; deg <= 150; deg += 10) target.find(stripe(0.0, 0.2, radians(deg)), 0.2);
  EXPECT_FALSE(target.find(stripe(0.8, 0.2), 0.2));
  const auto at = target.find(stripe(0.0, 0.2, radians(150)), 0.2);
  ASSERT_TRUE(at);
  EXPECT_GT(at->y, 0.1);
}

TEST(TargetFinder, OnItsOwnRedTrackArcAndErosionAreThePublishedOnes) {
  cv::Mat red(120, 160, CV_8UC3, cv::Scalar(120, 120, 120));
  cv::rectangle(red, cv::Rect(73, 0, 14, 120), cv::Scalar(20, 20, 220), cv::FILLED);  // columns 73…86
  TargetFinder own(camera(160, 120, 145.0), {}, {.name = "difference"});
  const auto target = own.find(red, std::nullopt);  // knows its stripe
  ASSERT_TRUE(target);
  EXPECT_NEAR(target->x * 145.0, 0.5, 0.01);  // an even square erodes half a pixel more on one side
  EXPECT_NEAR(std::hypot(target->x, target->y) * 145.0, 27.5, 0.5);
}

TEST(TargetFinder, RefusesOptionsOutOfBounds) {
  EXPECT_THROW(finder({.arc_half_widths = 0.0}), std::invalid_argument);
  EXPECT_THROW(finder({.least_arc_px = -1.0}), std::invalid_argument);
  EXPECT_THROW(finder({.eroded_share = 1.0}), std::invalid_argument);
  EXPECT_THROW(finder({.frame_width_px = 4}), std::invalid_argument);
}

TEST(PerceptionTarget, IsThereForThoseWhoAskForIt) {
  PerceptionOptions options;
  EXPECT_FALSE(Perception(camera(), options).observe(stripe(0.02, 0.2), {}).law.target);
  options.needs.target_point = true;
  const auto target = Perception(camera(), options).observe(stripe(0.02, 0.2), {}).law.target;
  ASSERT_TRUE(target);
  EXPECT_NEAR(target->x, 0.02, 0.5 / 80.0);
  EXPECT_NEAR(std::hypot(target->x, target->y), 0.16, 1.0 / 80.0);
}

TEST(PerceptionTarget, OffTheWayTheDirectionIsForgotten) {
  PerceptionOptions options;
  options.needs.target_point = true;
  Perception perception(camera(), options);
  for (int deg = 0; deg <= 150; deg += 10) perception.observe(stripe(0.0, 0.2, radians(deg)), {});
  const cv::Mat picture = stripe(0.0, 0.2, radians(150));
  EXPECT_GT(perception.observe(picture, {}).law.target.value().y, 0.1);
  FrameContext turning;
  turning.on_the_way = false;
  EXPECT_LT(perception.observe(picture, turning).law.target.value().y, -0.1);
}

}  // namespace
}  // namespace lineservo::features
