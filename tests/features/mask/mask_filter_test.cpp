#include "features/mask/mask_filter.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/support/floor_scenes.h"

namespace lineservo::features {
namespace {

using lineservo::support::random_mask;

const std::array<cv::Size, 10> kSizes = {
    {{400, 400}, {1, 1}, {2, 3}, {5, 5}, {63, 7}, {64, 64}, {65, 33}, {127, 5}, {128, 4}, {401, 399}}};

PackedMask median(const PackedMask& in) {
  PackedMask out(in.width(), in.height());
  MaskFilter(in.width(), in.height()).median_5x5(in, out);
  return out;
}

PackedMask closed(const PackedMask& in) {
  PackedMask out(in.width(), in.height());
  MaskFilter(in.width(), in.height()).close_5x5(in, out);
  return out;
}

class OnRandomMasks : public testing::TestWithParam<double> {};

TEST_P(OnRandomMasks, MedianEqualsOpenCv) {
  for (const cv::Size size : kSizes) {
    const cv::Mat mask = random_mask(size, GetParam(), 11);
    cv::Mat expected;
    cv::medianBlur(mask, expected, 5);
    EXPECT_EQ(median(PackedMask::from_mat(mask)), PackedMask::from_mat(expected)) << size;
  }
}

TEST_P(OnRandomMasks, ClosingEqualsOpenCv) {
  const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
  for (const cv::Size size : kSizes) {
    const cv::Mat mask = random_mask(size, GetParam(), 12);
    cv::Mat expected;
    cv::morphologyEx(mask, expected, cv::MORPH_CLOSE, kernel);
    EXPECT_EQ(closed(PackedMask::from_mat(mask)), PackedMask::from_mat(expected)) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Densities, OnRandomMasks,
                         testing::Values(0.0, 0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7, 0.8,
                                         0.9, 1.0));

// n pixels of the 5×5 square around the middle.
PackedMask first_of_25(int n) {
  PackedMask mask(21, 21);
  for (int i = 0; i < n; ++i) mask.set(8 + i % 5, 8 + i / 5);
  return mask;
}

TEST(Median, TakesThirteenOfTwentyFive) {
  EXPECT_FALSE(median(first_of_25(12)).at(10, 10));
  EXPECT_TRUE(median(first_of_25(13)).at(10, 10));
  EXPECT_TRUE(median(first_of_25(25)).at(10, 10));
}

TEST(Median, EveryCountFallsOnItsSideOfTheBound) {
  for (int n = 0; n <= 25; ++n) EXPECT_EQ(median(first_of_25(n)).at(10, 10), n >= 13) << n;
}

// A 4-px gap closes under a 5-px square, a 5-px gap stays.
TEST(Closing, FillsGapsNarrowerThanTheSquare) {
  for (const int gap : {1, 4, 5, 9}) {
    PackedMask mask(200, 9);
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 200; ++x) mask.set(x, y, x < 60 || x >= 60 + gap);
    EXPECT_EQ(closed(mask).count(), gap < 5 ? 200 * 9 : (200 - gap) * 9) << gap;
  }
}

TEST(Closing, WorksInPlace) {
  const PackedMask in = PackedMask::from_mat(random_mask({131, 77}, 0.3, 4));
  PackedMask inout = in;
  MaskFilter(131, 77).close_5x5(inout, inout);
  EXPECT_EQ(inout, closed(in));
}

TEST(Closing, KeepsBitsPastTheWidthZero) {
  PackedMask mask(70, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 70; ++x) mask.set(x, y);
  const PackedMask out = closed(median(mask));
  EXPECT_EQ(out.count(), 350);
  EXPECT_EQ(out.row(2)[1], 0x3FU);
}

}  // namespace
}  // namespace lineservo::features
