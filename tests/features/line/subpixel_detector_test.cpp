#include "features/line/subpixel_detector.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "features/geometry/angles.h"
#include "features/line/line_methods.h"
#include "features/perception.h"
#include "tests/features/line/drawn_stripe.h"

namespace lineservo::features {
namespace {

using test::draw_image;
using test::DrawnStripe;
using test::stripe_through;
using test::yellow_mask;

const cv::Size kSize(640, 480);
const Eigen::Vector3d kGrey(120, 122, 118), kYellow(10, 200, 230);

CameraModel camera(const std::array<double, 5>& distortion = {}) {
  return CameraModel({.distortion = distortion});  // 640×480, f = 320
}

std::vector<DetectedLine> detect(const cv::Mat& image, const CameraPose* pose = nullptr) {
  const PackedMask mask = yellow_mask(image);
  return SubpixelDetector().detect({.image = image, .mask = mask, .camera = pose});
}

/// A picture of whatever lies in the level camera, 4×4 samples a pixel.
template <typename Painted>
cv::Mat picture(const CameraPose& pose, Painted&& painted) {
  cv::Mat image(kSize, CV_8UC3);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      int hits = 0;
      for (int k = 0; k < 16; ++k) {
        const int column = k % 4, row = k / 4;
        const PixelPoint px{x - 0.375 + 0.25 * column, y - 0.375 + 0.25 * row};
        hits += int{painted(pose.view.level(pose.camera.normalize(px)).vector())};
      }
      const Eigen::Vector3d colour = kGrey + (kYellow - kGrey) * (hits / 16.0);
      for (int c = 0; c < 3; ++c) image.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<std::uint8_t>(colour[c]);
    }
  }
  return image;
}

void add_noise(cv::Mat& image, double sigma) {
  cv::RNG random(7);
  cv::Mat noise(image.size(), CV_16SC3);
  random.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
  cv::add(image, noise, image, cv::noArray(), CV_8UC3);
}

void expect_line(const ImageLine& line, const DrawnStripe& truth, double rho_px, double theta_deg) {
  const LineDifference d = difference(line, centreline(truth));
  EXPECT_LT(std::abs(d.rho_px), rho_px);
  EXPECT_LT(std::abs(degrees(d.theta_rad)), theta_deg);
}

TEST(SubpixelDetector, FindsAPerfectStripeToAFiftiethOfAPixel) {
  for (const double theta_deg : {0.0, 7.0, -28.0, 45.0, 75.0, 90.0}) {
    const DrawnStripe stripe = stripe_through(300.3, 251.7, theta_deg, 60.4);
    const auto lines = detect(draw_image(kSize, {stripe}));
    ASSERT_EQ(lines.size(), 1u);
    expect_line(lines[0].image, stripe, 0.02, 0.005);
    EXPECT_NEAR(lines[0].image.width_px, 60.4, 0.05);
    EXPECT_GT(lines[0].image.quality, 0.95);
    EXPECT_EQ(lines[0].image.curvature_inv_px, 0.0);
  }
}

TEST(SubpixelDetector, AThinLineToo) {
  const DrawnStripe stripe = stripe_through(300.3, 251.7, 12.0, 9.0);
  const auto lines = detect(draw_image(kSize, {stripe}));
  ASSERT_FALSE(lines.empty());
  expect_line(lines[0].image, stripe, 0.1, 0.03);
}

TEST(SubpixelDetector, NoiseBlurAndShadeMoveItLittleAndItsCovarianceSaysSo) {
  const DrawnStripe stripe = stripe_through(300.3, 251.7, 15.0, 60.0);
  cv::Mat image = draw_image(kSize, {stripe});
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image.at<cv::Vec3b>(y, x) =
          cv::Vec3b(cv::Vec3d(image.at<cv::Vec3b>(y, x)) * (0.6 + 0.4 * x / image.cols));
  cv::GaussianBlur(image, image, cv::Size(), 1.5);
  add_noise(image, 6.0);
  const auto lines = detect(image);
  ASSERT_FALSE(lines.empty());
  expect_line(lines[0].image, stripe, 0.2, 0.04);
  const LineDifference d = difference(lines[0].image, centreline(stripe));
  EXPECT_LT(std::abs(d.rho_px), 5.0 * std::sqrt(lines[0].image.covariance(0, 0)));
  EXPECT_LT(std::sqrt(lines[0].image.covariance(0, 0)), 0.2);
}

TEST(SubpixelDetector, GapsBlotsAndASideBranchAreOutvoted) {
  const DrawnStripe stripe = stripe_through(320.0, 240.0, 8.0, 60.0);
  cv::Mat image = draw_image(kSize, {stripe, stripe_through(320.0, 240.0, 95.0, 40.0)});
  cv::rectangle(image, {0, 0}, {280, 479}, cv::Scalar(120, 122, 118), cv::FILLED);  // one arm only
  image = image.clone();
  const cv::Mat whole = draw_image(kSize, {stripe});
  whole(cv::Rect(0, 0, 281, 480)).copyTo(image(cv::Rect(0, 0, 281, 480)));
  cv::rectangle(image, {200, 60}, {420, 85}, cv::Scalar(120, 122, 118), cv::FILLED);
  for (int k = 0; k < 12; ++k)
    cv::circle(image, {285 + 6 * (k % 5), 130 + 27 * k}, 9, cv::Scalar(120, 122, 118), cv::FILLED,
               cv::LINE_AA);
  const auto lines = detect(image);
  ASSERT_GE(lines.size(), 2u);
  expect_line(lines[0].image, stripe, 0.15, 0.05);
}

TEST(SubpixelDetector, TellsAnArcsTangentAndCurvature) {
  const CameraPose pose{camera(), LevelView()};
  const Eigen::Vector2d centre(2.5, 0.1);  // to the right: bends towards +x, the normal
  const cv::Mat image =
      picture(pose, [&](const Eigen::Vector2d& p) { return std::abs((p - centre).norm() - 2.4) < 0.15; });
  const auto lines = detect(image, &pose);
  ASSERT_FALSE(lines.empty());
  ASSERT_TRUE(lines[0].level);
  EXPECT_NEAR(lines[0].level->curvature, 1.0 / 2.4, 0.005);
  EXPECT_NEAR(lines[0].image.curvature_inv_px, 1.0 / 2.4 / 320.0, 2e-5);
  // The tangent where the arc is nearest to the image centre.
  const double expected_rad = std::atan2(centre.y(), centre.x());
  EXPECT_NEAR(lines[0].level->theta_rad, expected_rad, radians(0.05));
  EXPECT_NEAR(lines[0].level->rho, centre.norm() - 2.4, 1e-3);
  EXPECT_NEAR(lines[0].level->width, 0.3, 0.002);
}

TEST(SubpixelDetector, LensAndTiltAreTakenOutOfThePoints) {
  const CameraPose pose{camera({-0.25, 0.08, 0.001, -0.001, 0.0}), LevelView(radians(6.0), radians(-4.0))};
  const StripeCourse truth{.theta_rad = radians(10.0), .rho = 0.15, .width = 0.25};
  const StripeAxes axes(truth);
  const cv::Mat image =
      picture(pose, [&](const Eigen::Vector2d& p) { return std::abs(axes.across(p)) < 0.125; });
  const auto lines = detect(image, &pose);
  ASSERT_FALSE(lines.empty());
  ASSERT_TRUE(lines[0].level);
  EXPECT_NEAR(lines[0].level->rho, 0.15, 2e-4);
  EXPECT_NEAR(lines[0].level->theta_rad, radians(10.0), 3e-4);
  EXPECT_NEAR(lines[0].level->width, 0.25, 4e-4);
  EXPECT_EQ(lines[0].level->curvature, 0.0);
}

TEST(SubpixelDetector, WithoutACameraConvergingBordersGiveTheirBisector) {
  const CameraPose tilted{camera(), LevelView(0.0, radians(8.0))};
  const StripeAxes axes({.theta_rad = 0.0, .rho = 0.0, .width = 0.3});
  const cv::Mat image =
      picture(tilted, [&](const Eigen::Vector2d& p) { return std::abs(axes.across(p)) < 0.15; });
  const auto lines = detect(image);
  ASSERT_FALSE(lines.empty());
  expect_line(lines[0].image, {319.5, 0.0, 0.0}, 0.1, 0.03);  // pitch alone leaves the middle upright
}

TEST(SubpixelDetector, WhatTheImageDoesNotShowStaysAsTheMaskHasIt) {
  const DrawnStripe stripe = stripe_through(300.0, 250.0, 10.0, 60.0);
  const PackedMask mask = test::draw_mask(kSize, {stripe});
  const cv::Mat plain(kSize, CV_8UC3, cv::Scalar(90, 90, 90));
  const auto lines = SubpixelDetector().detect({.image = plain, .mask = mask});
  ASSERT_FALSE(lines.empty());
  expect_line(lines[0].image, stripe, 0.5, 0.15);
  EXPECT_LE(lines[0].image.quality, 0.5);
}

TEST(PerceptionLineMethod, GivesTheLinesOfTheMethodThatIsChosen) {
  const DrawnStripe stripe{319.5 + 40.0, 0.0, 64.0};  // ρ = 40/320, width 0.2
  const cv::Mat image = draw_image(kSize, {stripe});
  for (const LineMethod& method : line_methods()) {
    PerceptionOptions options;
    options.line_method = method.name;
    const FrameFeatures features = Perception(camera(), options).observe(image, FrameContext{});
    ASSERT_NE(features.line(), nullptr) << method.name;
    const double off = method.name == "naive" ? 0.11 : method.name == "subpixel" ? 1e-4 : 6e-3;
    EXPECT_NEAR(features.line()->rho, 0.125, off) << method.name;
    EXPECT_EQ(features.code.raw, JunctionCode::straight) << method.name;
  }
}

TEST(PerceptionLineMethod, RefusesAnUnknownLineMethod) {
  PerceptionOptions options;
  options.line_method = "hough";
  EXPECT_THROW(Perception(camera(), options), std::invalid_argument);
}

TEST(BorderRefiner, RefusesOptionsOutOfBounds) {
  EXPECT_THROW(BorderRefiner({.passes = 0}), std::invalid_argument);
  EXPECT_THROW(BorderRefiner({.points_per_border = 2}), std::invalid_argument);
  EXPECT_THROW(BorderRefiner({.reach_px = 1}), std::invalid_argument);
  EXPECT_THROW(BorderRefiner({.least_support = 1.5}), std::invalid_argument);
  EXPECT_NO_THROW(BorderRefiner({.passes = 1}));
}

}  // namespace
}  // namespace lineservo::features
