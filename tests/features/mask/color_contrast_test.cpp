#include "features/mask/color_contrast.h"

#include <gtest/gtest.h>

namespace lineservo::features {
namespace {

constexpr int kSize = 160;

/// A vertical stripe 24 px wide in the middle.
cv::Mat stripe(const cv::Scalar& floor, const cv::Scalar& paint) {
  cv::Mat picture(kSize, kSize, CV_8UC3, floor);
  picture(cv::Rect(68, 0, 24, kSize)).setTo(paint);
  return picture;
}

int on(const cv::Mat& contrast) {
  return contrast.at<std::uint8_t>(80, 80);
}
int off(const cv::Mat& contrast) {
  return contrast.at<std::uint8_t>(80, 20);
}

TEST(ColorContrast, WhiteIsOneMinusFloorOverPaint) {
  for (const double reach : {0.4, 1.0}) {
    const cv::Mat contrast =
        color_contrast(stripe({100, 100, 100}, {200, 200, 200}), LineColor::white, {reach});
    EXPECT_EQ(on(contrast), 255 * (200 - 100) / 200);
    EXPECT_EQ(off(contrast), 0);
  }
}

TEST(ColorContrast, BlackIsOneMinusPaintOverFloor) {
  const cv::Mat contrast = color_contrast(stripe({200, 200, 200}, {40, 40, 40}), LineColor::black, {0.4});
  EXPECT_EQ(on(contrast), 255 * (200 - 40) / 200);
  EXPECT_EQ(off(contrast), 0);
}

TEST(ColorContrast, HueIsTheDifferenceOfSaturations) {
  // Yellow (30, 180, 200): (180 − 30) / 200; the floor (80, 90, 100): (90 − 80) / 100.
  const cv::Mat yellow = color_contrast(stripe({80, 90, 100}, {30, 180, 200}), LineColor::yellow, {0.4});
  EXPECT_NEAR(on(yellow), 255 * (0.75 - 0.1), 1.0);
  EXPECT_EQ(off(yellow), 0);
  // Red (40, 50, 200): (200 − 50) / 200.
  const cv::Mat red = color_contrast(stripe({90, 90, 90}, {40, 50, 200}), LineColor::red, {0.4});
  EXPECT_NEAR(on(red), 255 * 0.75, 1.0);
  EXPECT_EQ(off(red), 0);
}

TEST(ColorContrast, YellowAndRedDoNotShowInEachOthersPlace) {
  EXPECT_EQ(on(color_contrast(stripe({90, 90, 90}, {40, 40, 200}), LineColor::yellow, {0.4})), 0);
  EXPECT_LT(on(color_contrast(stripe({90, 90, 90}, {40, 200, 200}), LineColor::red, {0.4})), 1);
}

TEST(ColorContrast, LightThatFallsOffDoesNotMatter) {
  cv::Mat picture = stripe({160, 160, 160}, {32, 32, 32});
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) picture.at<cv::Vec3b>(y, x) *= 0.5 + 0.5 * y / (kSize - 1);
  const cv::Mat contrast = color_contrast(picture, LineColor::black, {0.4});
  for (const int y : {10, 80, 150}) EXPECT_NEAR(contrast.at<std::uint8_t>(y, 80), 255 * 0.8, 12.0);
}

TEST(ColorContrast, AStripeWiderThanTheReachIsFloor) {
  cv::Mat wide(kSize, kSize, CV_8UC3, cv::Scalar(100, 100, 100));
  wide(cv::Rect(30, 0, 100, kSize)).setTo(cv::Scalar(200, 200, 200));
  EXPECT_EQ(on(color_contrast(wide, LineColor::white, {0.25})), 0);
  EXPECT_EQ(on(color_contrast(wide, LineColor::white, {0.8})), 127);
}

}  // namespace
}  // namespace lineservo::features
