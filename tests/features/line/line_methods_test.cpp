#include "features/line/line_methods.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "features/line/mask_pixels.h"
#include "tests/features/line/drawn_stripe.h"

namespace lineservo::features {
namespace {

using test::draw_image;
using test::draw_mask;
using test::DrawnStripe;
using test::stripe_through;
using test::yellow_mask;

const cv::Size kSize(480, 360);

/// What a method may be off by on a perfect picture of a stripe that the frame cuts. naive finds a border,
/// half a width off.
struct Tolerance {
  const char* method;
  double rho_px, theta_deg;
};
const Tolerance kTolerances[] = {{"naive", 22.0, 1.0},   {"centroid", 14.0, 4.0}, {"slices", 2.0, 1.5},
                                 {"fitline", 22.0, 6.0}, {"skeleton", 6.0, 2.0},  {"combined", 4.0, 1.5},
                                 {"stripe", 0.3, 0.1},   {"subpixel", 0.03, 0.01}};

std::vector<DetectedLine> detect(const char* method, const cv::Mat& image, const PackedMask& mask) {
  return find_line_method(method).make()->detect({.image = image, .mask = mask});
}

class LineMethods : public testing::TestWithParam<Tolerance> {};

TEST_P(LineMethods, FindsAStripeAtAnyAngle) {
  for (const double theta_deg : {0.0, 12.0, -25.0, 33.0, 80.0, -80.0, 90.0}) {
    const DrawnStripe stripe = stripe_through(250.0, 170.0, theta_deg, 40.0);
    const cv::Mat image = draw_image(kSize, {stripe});
    const auto lines = detect(GetParam().method, image, yellow_mask(image));
    ASSERT_FALSE(lines.empty()) << theta_deg;
    const ImageLine& line = lines.front().image;
    const LineDifference d = difference(line, centreline(stripe));
    EXPECT_LT(std::abs(d.rho_px), GetParam().rho_px) << theta_deg;
    EXPECT_LT(std::abs(degrees(d.theta_rad)), GetParam().theta_deg) << theta_deg;
    EXPECT_GT(line.theta_rad, -kPi / 2.0);
    EXPECT_LE(line.theta_rad, kPi / 2.0);
    EXPECT_GT(line.quality, 0.3);
    EXPECT_LE(line.quality, 1.0);
    EXPECT_GE(line.along(line.end), line.along(line.begin));
    EXPECT_GT(line.covariance(0, 0), 0.0);
    EXPECT_GT(line.covariance.determinant(), 0.0);
    EXPECT_FALSE(lines.front().level);
  }
}

TEST_P(LineMethods, RhoIsSigned) {
  const DrawnStripe stripe = stripe_through(150.0, 300.0, -60.0, 40.0);  // ρ = 75 − 260
  const cv::Mat image = draw_image(kSize, {stripe});
  const auto lines = detect(GetParam().method, image, yellow_mask(image));
  ASSERT_FALSE(lines.empty());
  EXPECT_LT(lines.front().image.rho_px, -150.0);
  EXPECT_NEAR(lines.front().image.theta_rad, radians(-60.0), radians(GetParam().theta_deg));
}

TEST_P(LineMethods, NothingToSeeGivesNone) {
  const cv::Mat plain(kSize, CV_8UC3, cv::Scalar(120, 120, 120));
  PackedMask empty(kSize.width, kSize.height), full(kSize.width, kSize.height),
      dot(kSize.width, kSize.height);
  PackedMask noise(kSize.width, kSize.height);
  test::TestRandom random(5);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      full.set(x, y);
      if (random.uniform(0.0, 1.0) < 0.3) noise.set(x, y);
    }
  dot.set(200, 200);
  for (const PackedMask* mask : {&empty, &full, &dot, &noise})
    EXPECT_TRUE(detect(GetParam().method, plain, *mask).empty());
}

TEST_P(LineMethods, AnImageOfOnePixelGivesNone) {
  const cv::Mat image(1, 1, CV_8UC3, cv::Scalar(0, 200, 230));
  PackedMask mask(1, 1);
  mask.set(0, 0);
  EXPECT_TRUE(detect(GetParam().method, image, mask).empty());
}

TEST_P(LineMethods, GreyImagesWillDoAndOtherTypesAreRefused) {
  const DrawnStripe stripe = stripe_through(250.0, 170.0, 10.0, 40.0);
  cv::Mat grey;
  cv::extractChannel(draw_image(kSize, {stripe}), grey, 2);
  const PackedMask mask = draw_mask(kSize, {stripe});
  const auto lines = detect(GetParam().method, grey, mask);
  ASSERT_FALSE(lines.empty());
  EXPECT_LT(std::abs(difference(lines.front().image, centreline(stripe)).rho_px), GetParam().rho_px);
  EXPECT_THROW(detect(GetParam().method, cv::Mat(kSize, CV_32FC1), mask), std::invalid_argument);
  EXPECT_THROW(detect(GetParam().method, cv::Mat(), mask), std::invalid_argument);
}

TEST_P(LineMethods, TheSameSceneGivesTheSameLinesAgain) {
  const cv::Mat image =
      draw_image(kSize, {stripe_through(250.0, 170.0, 10.0, 40.0), stripe_through(250.0, 170.0, 85.0, 30.0)});
  const PackedMask mask = yellow_mask(image);
  const auto detector = find_line_method(GetParam().method).make();
  const auto first = detector->detect({.image = image, .mask = mask});
  for (int again = 0; again < 2; ++again) {
    const auto next = detector->detect({.image = image, .mask = mask});
    ASSERT_EQ(next.size(), first.size());
    for (std::size_t i = 0; i < next.size(); ++i) {
      EXPECT_EQ(next[i].image.rho_px, first[i].image.rho_px);
      EXPECT_EQ(next[i].image.theta_rad, first[i].image.theta_rad);
    }
  }
}

TEST_P(LineMethods, AKnownCameraGivesTheLineInTheLevelView) {
  const DrawnStripe stripe{239.5 + 80.0, 0.0, 40.0};
  const cv::Mat image = draw_image(kSize, {stripe});
  const CameraPose pose{CameraModel({.width_px = 480,
                                     .height_px = 360,
                                     .fx_px = 240.0,
                                     .fy_px = 240.0,
                                     .cx_px = 239.5,
                                     .cy_px = 179.5}),
                        LevelView()};
  const PackedMask mask = yellow_mask(image);
  const auto lines = find_line_method(GetParam().method).make()->detect({image, mask, &pose});
  ASSERT_FALSE(lines.empty());
  ASSERT_TRUE(lines.front().level);
  EXPECT_NEAR(lines.front().level->rho, 80.0 / 240.0, GetParam().rho_px / 240.0);
  EXPECT_NEAR(lines.front().level->theta_rad, 0.0, radians(GetParam().theta_deg));
  EXPECT_LT(lines.front().level->end.y, lines.front().level->begin.y);
}

INSTANTIATE_TEST_SUITE_P(All, LineMethods, testing::ValuesIn(kTolerances),
                         [](const auto& tested) { return std::string(tested.param.method); });

TEST(LineMethodTable, EveryMethodIsTested) {
  ASSERT_EQ(line_methods().size(), std::size(kTolerances));
  for (std::size_t i = 0; i < line_methods().size(); ++i)
    EXPECT_EQ(line_methods()[i].name, kTolerances[i].method);
}

TEST(LineMethodTable, AnUnknownNameIsRefusedWithThoseThatThereAre) {
  try {
    find_line_method("hough");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("skeleton"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("'hough'"), std::string::npos);
  }
}

TEST(NaiveDetector, FindsABorderHalfAWidthOff) {
  const DrawnStripe stripe{239.5, 0.0, 40.0};
  const cv::Mat image = draw_image(kSize, {stripe});
  const auto lines = detect("naive", image, yellow_mask(image));
  ASSERT_FALSE(lines.empty());
  EXPECT_NEAR(std::abs(lines.front().image.rho_px - 239.5), 20.0, 1.5);
}

// kPoints of the mask give the line that all 16,000 of them give.
TEST(FitlineDetector, ASampleOfThePaintGivesTheLineOfAllOfIt) {
  for (const double theta_deg : {0.0, 33.0, -80.0}) {
    const DrawnStripe stripe = stripe_through(250.0, 170.0, theta_deg, 40.0);
    const cv::Mat image = draw_image(kSize, {stripe});
    const PackedMask mask = yellow_mask(image);
    std::vector<cv::Point2f> points;
    for_each_pixel(
        mask, [&points](int x, int y) { points.emplace_back(static_cast<float>(x), static_cast<float>(y)); });
    cv::Vec4f all;
    cv::fitLine(points, all, cv::DIST_HUBER, 0.0, 0.01, 0.01);
    const ImageLine expected =
        line_through({all[2], all[3]}, {all[2] + 100.0 * all[0], all[3] + 100.0 * all[1]});
    const auto lines = detect("fitline", image, mask);
    ASSERT_FALSE(lines.empty()) << theta_deg;
    const PixelPoint middle{250.0, 170.0};
    EXPECT_NEAR(std::abs(lines.front().image.across(middle)), std::abs(expected.across(middle)), 1.0);
    EXPECT_LT(std::abs(degrees(difference(lines.front().image, expected).theta_rad)), 0.5) << theta_deg;
  }
}

TEST(MaskMethods, AMaskOfAnotherSizeGivesPixelsOfTheImage) {
  const DrawnStripe stripe = stripe_through(250.0, 170.0, 20.0, 40.0);
  const cv::Mat image = draw_image(kSize, {stripe});
  PackedMask small(240, 240);  // half as wide, two thirds as high
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x)
      if (coverage(stripe, 2 * x, (3 * y + 1) / 2) > 0.5) small.set(x, y);
  for (const char* method : {"slices", "combined", "stripe"}) {
    const auto lines = detect(method, image, small);
    ASSERT_FALSE(lines.empty()) << method;
    const LineDifference d = difference(lines.front().image, centreline(stripe));
    EXPECT_LT(std::abs(d.rho_px), 6.0) << method;
    EXPECT_LT(std::abs(degrees(d.theta_rad)), 1.5) << method;
    EXPECT_NEAR(lines.front().image.width_px, 40.0, 4.0) << method;
  }
}

TEST(SkeletonDetector, TellsLinesUpFromLinesAcross) {
  const DrawnStripe up = stripe_through(250.0, 170.0, 5.0, 30.0),
                    across = stripe_through(250.0, 170.0, 92.0, 30.0);
  const cv::Mat image = draw_image(kSize, {across, up});
  const auto lines = detect("skeleton", image, yellow_mask(image));
  ASSERT_GE(lines.size(), 2u);
  EXPECT_LT(std::abs(degrees(difference(lines[0].image, centreline(up)).theta_rad)), 4.0);
  bool has_across = false;
  for (const DetectedLine& line : lines)
    has_across |= std::abs(degrees(difference(line.image, centreline(across)).theta_rad)) < 4.0;
  EXPECT_TRUE(has_across);
}

}  // namespace
}  // namespace lineservo::features
