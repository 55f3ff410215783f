#include "apps/evaluate/line_frames.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "apps/evaluate/degradations.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::PixelPoint;

const cv::Size kSize(640, 480);

double largest_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

bool is_yellow(const cv::Mat& bgr, const PixelPoint& at) {
  const cv::Vec3b p = bgr.at<cv::Vec3b>(static_cast<int>(at.y + 0.5), static_cast<int>(at.x + 0.5));
  return p[2] > p[0] + 60;
}

// The paint's extent to both sides of the true line, at a place of it.
std::pair<int, int> paint_beside(const LineFrame& frame, double along_px) {
  const auto inside = [&frame](const PixelPoint& p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x < frame.bgr.cols - 1 && p.y < frame.bgr.rows - 1;
  };
  const PixelPoint p = frame.truth->at(along_px);
  const Eigen::Vector2d n = frame.truth->normal();
  std::pair<int, int> reach{0, 0};
  for (const int side : {-1, 1}) {
    int& far = side < 0 ? reach.first : reach.second;
    for (PixelPoint at = p; inside(at) && is_yellow(frame.bgr, at);
         at = {p.x + side * far * n.x(), p.y + side * far * n.y()})
      ++far;
  }
  return reach;
}

TEST(LineFrames, TheTrueLineRunsInsideThePaint) {
  int with_line = 0;
  for (int index = 0; index < 20; ++index) {
    const LineFrame frame = make_line_frame(kSize, FrameLevel::clean, 4, index);
    ASSERT_EQ(frame.bgr.size(), kSize);
    if (!frame.truth) continue;
    ++with_line;
    const auto stretch = stretch_in_image(*frame.truth, kSize);
    ASSERT_TRUE(stretch);
    const auto [low, high] = paint_beside(frame, 0.5 * (stretch->first + stretch->second));
    EXPECT_GT(low, 2);
    EXPECT_GT(high, 2);
    // Perspective puts the middle of the paint off the middle of the picture of it, but not by half.
    EXPECT_LT(std::abs(low - high), 0.5 * (low + high));
  }
  EXPECT_GT(with_line, 12);
  EXPECT_LT(with_line, 20);
}

TEST(LineFrames, AFrameWithoutALineHasNoPaint) {
  for (int index = 0; index < 40; ++index) {
    const LineFrame frame = make_line_frame(kSize, FrameLevel::clean, 4, index);
    if (frame.truth) continue;
    cv::Scalar mean, deviation;
    cv::meanStdDev(frame.bgr, mean, deviation);
    EXPECT_EQ(deviation, cv::Scalar::all(0.0));
  }
}

TEST(LineFrames, TheSameArgumentsGiveTheSameFrameAndOthersAnother) {
  for (const FrameLevel level : kFrameLevels) {
    const LineFrame a = make_line_frame(kSize, level, 9, 3), b = make_line_frame(kSize, level, 9, 3);
    EXPECT_EQ(largest_difference(a.bgr, b.bgr), 0.0);
    ASSERT_EQ(a.truth.has_value(), b.truth.has_value());
    if (a.truth) {
      EXPECT_EQ(a.truth->rho_px, b.truth->rho_px);
    }
    EXPECT_GT(largest_difference(a.bgr, make_line_frame(kSize, level, 9, 4).bgr), 0.0);
    EXPECT_GT(largest_difference(a.bgr, make_line_frame(kSize, level, 10, 3).bgr), 0.0);
  }
}

TEST(Degradations, LightStaysWithinItsGains) {
  vehicle::Random random(1);
  cv::Mat bgr(kSize, CV_8UC3, cv::Scalar::all(100));
  uneven_light(bgr, 0.4, 1.3, random);
  double low = 0.0, high = 0.0;
  cv::minMaxLoc(bgr.reshape(1), &low, &high);
  EXPECT_GE(low, 40.0);
  EXPECT_LE(high, 130.0);
  EXPECT_GT(high - low, 20.0);
}

TEST(Degradations, GlareOnlyBrightens) {
  vehicle::Random random(2);
  cv::Mat bgr(kSize, CV_8UC3, cv::Scalar::all(100));
  specular_patch(bgr, 100.0, random);
  double low = 0.0, high = 0.0;
  cv::minMaxLoc(bgr.reshape(1), &low, &high);
  EXPECT_EQ(low, 100.0);
  EXPECT_GE(high, 195.0);
  EXPECT_LE(high, 200.0);
}

TEST(Degradations, SofteningKeepsTheSumAndNothingBelowATenth) {
  cv::Mat bgr(kSize, CV_8UC3, cv::Scalar::all(0));
  bgr(cv::Rect(200, 100, 100, 100)).setTo(200);
  const cv::Mat before = bgr.clone();
  soften(bgr, 0.05);
  EXPECT_EQ(largest_difference(bgr, before), 0.0);
  soften(bgr, 2.0);
  EXPECT_NEAR(cv::sum(bgr)[0] / cv::sum(before)[0], 1.0, 0.01);
  EXPECT_NEAR(bgr.at<cv::Vec3b>(150, 200)[0], 110, 12);  // the step's first pixel: half and a half pixel
}

TEST(Degradations, AFlatBlockSurvivesJpegAndDetailSuffersWithTheQuality) {
  cv::Mat flat(64, 64, CV_8UC3, cv::Scalar(120, 130, 110));
  const cv::Mat before = flat.clone();
  jpeg_blocks(flat, 90);
  EXPECT_LE(largest_difference(flat, before), 3.0);
  cv::Mat noise(64, 64, CV_8UC3), fine, coarse;
  cv::RNG(5).fill(noise, cv::RNG::UNIFORM, 60, 200);
  fine = noise.clone();
  coarse = noise.clone();
  jpeg_blocks(fine, 95);
  jpeg_blocks(coarse, 20);
  EXPECT_GT(cv::norm(fine, noise), 0.0);
  EXPECT_GT(cv::norm(coarse, noise), 1.2 * cv::norm(fine, noise));
}

}  // namespace
}  // namespace lineservo::apps
