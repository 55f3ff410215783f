#include "features/detect/stripe_evidence.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace lineservo::features {
namespace {

constexpr int kSide_px = 100;

/// Full contrast in the columns [from, to), none beside them.
PaintContrast columns(int from, int to) {
  PaintContrast paint{.contrast = cv::Mat::zeros(kSide_px, kSide_px, CV_8UC1), .full = 200.0};
  paint.contrast.colRange(from, to) = 200;
  return paint;
}

/// An upright line between two columns, in view or not, over most of the height.
WedgeLine upright(double from_px, double to_px) {
  const MaskGeometry geometry = assumed_geometry(kSide_px, kSide_px);
  const double left = geometry.normalize({from_px, 0.0}).x, right = geometry.normalize({to_px, 0.0}).x;
  WedgeLine line;
  line.wedge.course = {.theta_rad = 0.0, .rho = 0.5 * (left + right), .width = right - left};
  line.begin = -0.8;
  line.end = 0.8;
  return line;
}

double sharpness_of(const WedgeLine& line, const PaintContrast& paint) {
  return sharpness(line, paint, assumed_geometry(kSide_px, kSide_px));
}

TEST(Sharpness, OfFullContrastIsOneAndOfNoneZero) {
  EXPECT_EQ(sharpness_of(upright(39.5, 59.5), columns(40, 60)), 1.0);
  EXPECT_EQ(sharpness_of(upright(39.5, 59.5), columns(0, 100)), 0.0);
}

TEST(Sharpness, TheSofterBorderCounts) {
  EXPECT_EQ(sharpness_of(upright(39.5, 59.5), columns(40, 100)), 0.0);
  EXPECT_EQ(sharpness_of(upright(39.5, 59.5), columns(0, 60)), 0.0);
}

TEST(Sharpness, ABorderOutOfViewDoesNotCount) {
  EXPECT_EQ(sharpness_of(upright(-8.5, 14.5), columns(0, 15)), 1.0);
  EXPECT_EQ(sharpness_of(upright(84.5, 108.5), columns(85, 100)), 1.0);
  EXPECT_EQ(sharpness_of(upright(84.5, 108.5), columns(0, 100)), 0.0);
  EXPECT_EQ(sharpness_of(upright(-8.5, 108.5), columns(0, 100)), 0.0);
}

}  // namespace
}  // namespace lineservo::features
