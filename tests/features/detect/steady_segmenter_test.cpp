#include "features/detect/steady_segmenter.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace lineservo::features {
namespace {

const cv::Size kSize(200, 200);
const cv::Scalar kFloor(110, 112, 115), kYellow(20, 200, 230), kRed(40, 40, 210);

/// A stripe up the picture, and one across it when it is a crossing.
cv::Mat floor_with(const cv::Scalar& paint, int width_px, bool crossing = false) {
  cv::Mat picture(kSize, CV_8UC3, kFloor);
  const int from = (kSize.width - width_px) / 2;
  picture(cv::Rect(from, 0, width_px, kSize.height)).setTo(paint);
  if (crossing) picture(cv::Rect(0, from, kSize.width, width_px)).setTo(paint);
  return picture;
}

int wrong_pixels(const PackedMask& mask, const cv::Mat& picture, const cv::Scalar& paint) {
  cv::Mat truth;
  cv::inRange(picture, paint, paint, truth);
  cv::Mat differs;
  cv::bitwise_xor(truth, mask.to_mat(), differs);
  return cv::countNonZero(differs);
}

TEST(SteadySegmenter, KeepsTheColourOverABroadCrossing) {
  const cv::Mat crossing = floor_with(kYellow, 100, true);  // three quarters of it paint
  SteadySegmenter segmenter;
  for (int k = 0; k < 3; ++k) segmenter.segment(floor_with(kYellow, 84), kSize);
  ASSERT_EQ(segmenter.color(), LineColor::yellow);
  EXPECT_LT(wrong_pixels(segmenter.segment(crossing, kSize), crossing, kYellow), 8 * 200);
  EXPECT_GT(wrong_pixels(AutoSegmenter().segment(crossing, kSize), crossing, kYellow), 20 * 200);
}

TEST(SteadySegmenter, KeepsWhiteToo) {
  const cv::Scalar white(230, 230, 230);
  SteadySegmenter segmenter;
  for (int k = 0; k < 3; ++k) segmenter.segment(floor_with(white, 30), kSize);
  ASSERT_EQ(segmenter.color(), LineColor::white);
  const cv::Mat crossing = floor_with(white, 84, true);
  EXPECT_LT(wrong_pixels(segmenter.segment(crossing, kSize), crossing, white), 8 * 200);
}

TEST(SteadySegmenter, OneFrameDoesNotMakeAColour) {
  SteadySegmenter segmenter;
  segmenter.segment(floor_with(kRed, 30), kSize);
  for (int k = 0; k < 2; ++k) segmenter.segment(floor_with(kYellow, 30), kSize);
  EXPECT_FALSE(segmenter.color());
  segmenter.segment(floor_with(kYellow, 30), kSize);
  EXPECT_EQ(segmenter.color(), LineColor::yellow);
}

TEST(SteadySegmenter, GivesAColourUpThatIsSeenNoMore) {
  SteadySegmenter segmenter({.agreeing_frames = 1, .forgiven_frames = 2});
  segmenter.segment(floor_with(kYellow, 30), kSize);
  ASSERT_EQ(segmenter.color(), LineColor::yellow);
  const cv::Mat red = floor_with(kRed, 30);
  EXPECT_EQ(segmenter.segment(red, kSize).count(), 0);
  EXPECT_EQ(segmenter.color(), LineColor::yellow);
  segmenter.segment(red, kSize);
  EXPECT_FALSE(segmenter.color());
  EXPECT_LT(wrong_pixels(segmenter.segment(red, kSize), red, kRed), 4 * 200);
  EXPECT_EQ(segmenter.color(), LineColor::red);
}

// The grey between the arms of a broad corner with a disc on it looks like a dark line, surer than what is
// yellow.
TEST(SteadySegmenter, StrongColourIsPaintWhateverItsShape) {
  cv::Mat corner(kSize, CV_8UC3, kFloor);
  corner(cv::Rect(64, 0, 72, 136)).setTo(kYellow);
  corner(cv::Rect(64, 64, 136, 72)).setTo(kYellow);
  cv::circle(corner, {100, 100}, 36, kRed, cv::FILLED);
  SteadyOptions options;
  std::erase(options.search.colors, LineColor::red);
  SteadySegmenter segmenter(options);
  const PackedMask mask = segmenter.segment(corner, kSize);
  EXPECT_GT(mask.count(), 0);
  cv::Mat floor;
  cv::inRange(corner, kFloor, kFloor, floor);
  cv::bitwise_and(floor, mask.to_mat(), floor);
  EXPECT_LT(cv::countNonZero(floor), 4 * 200);
}

TEST(SteadySegmenter, RefusesCountsBelowOne) {
  EXPECT_THROW(SteadySegmenter({.agreeing_frames = 0}), std::invalid_argument);
  EXPECT_THROW(SteadySegmenter({.forgiven_frames = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
