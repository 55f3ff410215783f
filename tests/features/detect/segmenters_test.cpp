#include "features/detect/segmenters.h"

#include <gtest/gtest.h>

#include "features/detect/auto_segmenter.h"
#include "features/mask/difference_segmenter.h"
#include "features/mask/hsv_segmenter.h"

namespace lineservo::features {
namespace {

const cv::Scalar kGrey(100, 100, 100);

/// 96×64 with paint in columns 40…63.
cv::Mat stripe(const cv::Scalar& floor, const cv::Scalar& paint) {
  cv::Mat picture(64, 96, CV_8UC3, floor);
  picture(cv::Rect(40, 0, 24, 64)).setTo(paint);
  return picture;
}

PackedMask columns(int from, int to) {
  PackedMask mask(96, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = from; x < to; ++x) mask.set(x, y);
  return mask;
}

TEST(HsvSegmenter, EachPresetTakesItsColourAndNoOther) {
  const std::array<cv::Scalar, 4> paints = {cv::Scalar(30, 190, 220), cv::Scalar(40, 35, 200),
                                            cv::Scalar(225, 225, 225), cv::Scalar(30, 30, 30)};
  for (std::size_t paint = 0; paint < paints.size(); ++paint) {
    for (std::size_t preset = 0; preset < kLineColors.size(); ++preset) {
      HsvSegmenter segmenter(kLineColors[preset]);
      const PackedMask mask = segmenter.segment(stripe(kGrey, paints[paint]), {96, 64});
      EXPECT_EQ(mask, paint == preset ? columns(40, 64) : columns(0, 0)) << paint << " " << preset;
    }
  }
}

TEST(AnyLight, TakesYellowInDeepShade) {
  const auto segmenter = make_segmenter({.name = "any-light"});
  EXPECT_EQ(segmenter->segment(stripe({30, 30, 30}, {8, 48, 55}), {96, 64}), columns(40, 64));
  EXPECT_EQ(segmenter->segment(stripe({30, 30, 30}, {10, 10, 55}), {96, 64}), columns(0, 0));  // red
}

TEST(AnyLight, HasBoundsOfItsOwnAndTheSizeThatIsGiven) {
  SegmenterOptions given;
  given.width_px = 160;
  const SegmenterOptions ranges = ranges_of({.name = "any-light"}, given);
  EXPECT_EQ(ranges.width_px, 160);
  EXPECT_EQ(ranges.path.c_min, any_light_ranges().path.c_min);
  EXPECT_EQ(ranges_of({.name = "hsv"}, given).path.c_min, 0);
  EXPECT_TRUE(is_fast({.name = "hsv"}) && is_fast({.name = "any-light"}));
  EXPECT_FALSE(is_fast({.name = "auto"}));
}

TEST(YellowWhite, TakesBothWithoutASeamAndNeitherRedNorBlack) {
  const auto segmenter = make_segmenter({.name = "yellow-white"});
  cv::Mat floor = stripe(kGrey, {30, 190, 220});
  floor(cv::Rect(40, 0, 24, 32)).setTo(cv::Scalar(235, 235, 235));
  EXPECT_EQ(segmenter->segment(floor, {96, 64}), columns(40, 64));
  EXPECT_EQ(segmenter->segment(stripe(kGrey, {40, 35, 200}), {96, 64}), columns(0, 0));
  EXPECT_EQ(segmenter->segment(stripe(kGrey, {30, 30, 30}), {96, 64}), columns(0, 0));
}

TEST(HsvSegmenter, TakesGreyImages) {
  cv::Mat grey(64, 96, CV_8UC1, cv::Scalar(100));
  grey(cv::Rect(40, 0, 24, 64)).setTo(230);
  EXPECT_EQ(HsvSegmenter(LineColor::white).segment(grey, {96, 64}), columns(40, 64));
}

TEST(DifferenceSegmenter, ErodesTheRedStripe) {
  // F = 200 − 40 / 2 − 20 / 2 = 170. An 8×8 square anchored at its fifth pixel takes 4 px left and 3 px
  // right.
  const PackedMask mask = DifferenceSegmenter().segment(stripe(kGrey, {20, 40, 200}), {96, 64});
  EXPECT_EQ(mask, columns(44, 61));
}

TEST(DifferenceSegmenter, TheThresholdIsIncluded) {
  // F = 140 − 40 / 2 − 40 / 2 = 100, and one less.
  DifferenceSegmenter segmenter({.erosion_px = 1});
  EXPECT_EQ(segmenter.segment(stripe(kGrey, {40, 40, 140}), {96, 64}), columns(40, 64));
  EXPECT_EQ(segmenter.segment(stripe(kGrey, {40, 40, 139}), {96, 64}), columns(0, 0));
}

TEST(DifferenceSegmenter, RefusesOptionsOutOfBounds) {
  EXPECT_THROW(DifferenceSegmenter({.green_divisor = 0.9}), std::invalid_argument);
  EXPECT_THROW(DifferenceSegmenter({.blue_divisor = 0.9}), std::invalid_argument);
  EXPECT_THROW(DifferenceSegmenter({.threshold = 256.0}), std::invalid_argument);
  EXPECT_THROW(DifferenceSegmenter({.erosion_px = 0}), std::invalid_argument);
}

TEST(Segmenters, EachHasTheSizeThatWasAskedFor) {
  for (const std::string_view name : {"hsv", "any-light", "yellow-white", "difference", "auto"}) {
    const PackedMask mask =
        make_segmenter({.name = std::string(name)})->segment(stripe(kGrey, {20, 40, 200}), {48, 32});
    EXPECT_EQ(mask.width(), 48) << name;
    EXPECT_EQ(mask.height(), 32) << name;
  }
}

TEST(Segmenters, RefuseWhatTheyCannotTake) {
  for (const std::string_view name : {"hsv", "any-light", "yellow-white", "difference", "auto"}) {
    const auto segmenter = make_segmenter({.name = std::string(name)});
    EXPECT_THROW(segmenter->segment(cv::Mat(), {64, 64}), std::invalid_argument) << name;
    EXPECT_THROW(segmenter->segment(cv::Mat(64, 64, CV_32FC1), {64, 64}), std::invalid_argument) << name;
    EXPECT_THROW(segmenter->segment(cv::Mat(64, 15, CV_8UC3), {64, 64}), std::invalid_argument) << name;
    EXPECT_THROW(segmenter->segment(cv::Mat(64, 64, CV_8UC3), {64, 15}), std::invalid_argument) << name;
  }
  EXPECT_THROW(make_segmenter({.name = "otsu"}), std::invalid_argument);
  EXPECT_THROW(make_segmenter({.name = "svm", .svm_model = "nonsense"}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
