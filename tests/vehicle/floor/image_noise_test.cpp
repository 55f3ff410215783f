#include "vehicle/floor/image_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace lineservo::vehicle {
namespace {

constexpr int kGreyLevel = 100;

// The noise of one frame, in grey levels, on a flat image.
cv::Mat noise_of(const ImageNoise& noise, std::int64_t frame) {
  cv::Mat bgr(480, 640, CV_8UC3, cv::Scalar::all(kGreyLevel));
  noise.add(frame, bgr);
  cv::Mat values;
  bgr.reshape(1).convertTo(values, CV_64F, 1.0, -kGreyLevel);
  return values;
}

double correlation(const cv::Mat& a, const cv::Mat& b) {
  return a.dot(b) / std::sqrt(a.dot(a) * b.dot(b));
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(ImageNoise, HasTheMeanAndSpreadAskedFor) {
  for (const double sigma : {2.0 / 255.0, 6.0 / 255.0}) {
    cv::Scalar mean, spread;
    cv::meanStdDev(noise_of(ImageNoise(sigma, 3), 0), mean, spread);
    EXPECT_NEAR(mean[0], 0.0, 0.02);
    const double levels = 255.0 * sigma;
    EXPECT_NEAR(spread[0], std::sqrt(levels * levels + 1.0 / 12.0), 0.01 * levels);
  }
}

TEST(ImageNoise, IsNormal) {
  const cv::Mat values = noise_of(ImageNoise(4.0 / 255.0, 1), 0);
  const double count = static_cast<double>(values.total());
  EXPECT_NEAR(cv::countNonZero(cv::abs(values) < 4.5) / count, 0.7394, 0.005);    // erf(4.5/4/√2)
  EXPECT_NEAR(cv::countNonZero(cv::abs(values) > 10.5) / count, 0.00866, 0.001);  // erfc(10.5/4/√2)
}

TEST(ImageNoise, SaturatesInsteadOfWrapping) {
  const ImageNoise noise(0.1, 5);
  cv::Mat black(64, 64, CV_8UC3, cv::Scalar::all(0)), white(64, 64, CV_8UC3, cv::Scalar::all(255));
  noise.add(0, black);
  noise.add(0, white);
  double lowest, highest;
  cv::minMaxLoc(black.reshape(1), &lowest, &highest);
  EXPECT_EQ(lowest, 0.0);
  EXPECT_LE(highest, 127.0);
  cv::minMaxLoc(white.reshape(1), &lowest, &highest);
  EXPECT_GE(lowest, 128.0);
  EXPECT_EQ(highest, 255.0);
}

TEST(ImageNoise, RowsAndFramesDoNotCorrelate) {
  const ImageNoise noise(4.0 / 255.0, 7);
  const cv::Mat first = noise_of(noise, 0), second = noise_of(noise, 1);
  // Of 1/√n: 0.001 for frames; over all rows as well.
  EXPECT_NEAR(correlation(first, second), 0.0, 0.006);
  EXPECT_NEAR(correlation(first.rowRange(1, 480), first.rowRange(0, 479)), 0.0, 0.006);
  EXPECT_NEAR(correlation(first.colRange(3, 1920), first.colRange(0, 1917)), 0.0, 0.006);
}

TEST(ImageNoise, DependsOnSeedAndFrameAlone) {
  const ImageNoise noise(4.0 / 255.0, 7), again(4.0 / 255.0, 7), other(4.0 / 255.0, 8);
  noise_of(again, 4);
  EXPECT_TRUE(same(noise_of(noise, 5), noise_of(again, 5)));
  EXPECT_FALSE(same(noise_of(noise, 5), noise_of(noise, 6)));
  EXPECT_FALSE(same(noise_of(noise, 5), noise_of(other, 5)));
}

TEST(ImageNoise, WithoutNoiseNothingChanges) {
  EXPECT_EQ(cv::countNonZero(noise_of(ImageNoise(0.0, 1), 0)), 0);
}

TEST(ImageNoise, RefusesWhatIsOutOfBounds) {
  EXPECT_THROW(ImageNoise(-0.001, 1), std::invalid_argument);
  EXPECT_THROW(ImageNoise(0.1001, 1), std::invalid_argument);
  EXPECT_THROW(ImageNoise(std::nan(""), 1), std::invalid_argument);
  EXPECT_NO_THROW(ImageNoise(0.1, 1));
}

}  // namespace
}  // namespace lineservo::vehicle
