#include <gtest/gtest.h>

#include "features/geometry/angles.h"
#include "features/line/hough_lines.h"
#include "features/line/level_line.h"
#include "features/line/mask_support.h"
#include "features/line/ransac_line.h"
#include "features/line/slices_detector.h"
#include "tests/features/line/drawn_stripe.h"

namespace lineservo::features {
namespace {

using test::draw_mask;

TEST(RansacLine, StrayPointsDoNotMoveIt) {
  const ImageLine truth = canonical_line(120.0, radians(20.0));
  std::vector<PixelPoint> points;
  points.reserve(32);
  for (int k = 0; k < 20; ++k) points.push_back(truth.at(10.0 * k));
  for (int k = 0; k < 12; ++k) points.push_back({37.0 * (k % 7), 300.0 - 23.0 * k});
  const auto line = ransac_line(points, {.reach_px = 2.0});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->rho_px, 120.0, 0.5);
  EXPECT_NEAR(line->theta_rad, radians(20.0), radians(0.5));
}

TEST(RansacLine, TooFewPointsGiveNone) {
  EXPECT_FALSE(ransac_line({}, {}));
  EXPECT_FALSE(ransac_line({{1.0, 1.0}, {5.0, 9.0}}, {}));
  EXPECT_TRUE(ransac_line({{1.0, 1.0}, {5.0, 5.0}, {9.0, 9.0}}, {}));
}

TEST(SlicesDetector, LessPaintMeansMoreSlices) {
  EXPECT_EQ(SlicesDetector::slice_count(0.9), 6);
  EXPECT_EQ(SlicesDetector::slice_count(0.2), 10);
  EXPECT_EQ(SlicesDetector::slice_count(0.1), 20);
  EXPECT_EQ(SlicesDetector::slice_count(0.001), 40);
}

TEST(HoughClusters, NearLinesBecomeTheirMeanByVotes) {
  const ClusterReach reach{20.0, radians(10.0)};
  const auto means = cluster_lines({{canonical_line(100.0, radians(2.0)), 30.0},
                                    {canonical_line(108.0, radians(-2.0)), 10.0},
                                    {canonical_line(300.0, radians(0.0)), 5.0},
                                    {canonical_line(200.0, radians(88.0)), 55.0}},
                                   reach);
  ASSERT_EQ(means.size(), 3u);  // up before across
  EXPECT_NEAR(means[0].rho_px, 102.0, 1e-9);
  EXPECT_NEAR(means[0].theta_rad, radians(1.0), 1e-12);
  EXPECT_NEAR(means[1].rho_px, 300.0, 1e-9);
  EXPECT_NEAR(means[2].rho_px, 200.0, 1e-9);
}

TEST(HoughClusters, AForkWithFewVotesDoesNotComeBeforeTheLineAcross) {
  const ClusterReach reach{20.0, radians(10.0)};
  const VotedLine fork{canonical_line(100.0, radians(40.0)), 30.0};
  EXPECT_NEAR(cluster_lines({{canonical_line(200.0, radians(88.0)), 91.0}, fork}, reach)[0].rho_px, 200.0,
              1e-9);
  EXPECT_NEAR(cluster_lines({{canonical_line(200.0, radians(88.0)), 89.0}, fork}, reach)[0].rho_px, 100.0,
              1e-9);
}

TEST(HoughClusters, TheMeanOfLinesAcrossTheWrapStaysThere) {
  const auto means = cluster_lines(
      {{canonical_line(200.0, radians(89.0)), 10.0}, {canonical_line(-202.0, radians(-89.0)), 10.0}},
      {20.0, radians(10.0)});
  ASSERT_EQ(means.size(), 1u);
  EXPECT_NEAR(std::abs(means[0].theta_rad), radians(90.0), 1e-9);
  EXPECT_NEAR(std::abs(means[0].rho_px), 201.0, 1e-9);
}

TEST(MaskSupport, MeasuresEndsWidthAndQuality) {
  PackedMask mask(300, 200);
  for (int y = 40; y < 160; ++y)
    for (int x = 95; x < 106; ++x) mask.set(x, y);
  const auto line = supported_line(canonical_line(100.0, 0.0), mask);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->width_px, 11.0, 1e-9);
  EXPECT_NEAR(line->begin.y, 159.0, 1.0);
  EXPECT_NEAR(line->end.y, 40.0, 1.0);
  EXPECT_NEAR(line->quality, 1.0, 0.02);
  EXPECT_LT(std::sqrt(line->covariance(0, 0)), 0.5);
}

TEST(MaskSupport, ALineBesideThePaintOrBarelyOnItIsNone) {
  const PackedMask mask = draw_mask({300, 200}, {{100.0, 0.0, 11.0}});
  EXPECT_FALSE(supported_line(canonical_line(120.0, 0.0), mask));
  EXPECT_FALSE(supported_line(canonical_line(100.0, radians(90.0)), mask));
  EXPECT_FALSE(supported_line(canonical_line(-50.0, 0.0), mask));
}

TEST(LevelLine, PixelsOfALevelCameraAreItsNormalisedUnits) {
  const CameraPose pose{CameraModel(CameraParameters{}), LevelView()};
  ImageLine line = line_through({319.5 + 32.0, 400.0}, {319.5 + 32.0, 50.0});
  line.width_px = 16.0;
  line.covariance = Eigen::Vector2d(4.0, 1e-4).asDiagonal();
  const LineFeature level = level_line(line, pose);
  EXPECT_NEAR(level.rho, 0.1, 1e-12);
  EXPECT_NEAR(level.theta_rad, 0.0, 1e-12);
  EXPECT_NEAR(level.width, 0.05, 1e-12);
  EXPECT_LT(level.end.y, level.begin.y);
  EXPECT_NEAR(level.covariance(1, 1), 1e-4, 1e-9);
  EXPECT_TRUE(image_covariance(line, level.covariance, pose).isApprox(line.covariance, 1e-6));
}

TEST(LevelLine, TiltIsTakenOut) {
  const CameraPose pose{CameraModel(CameraParameters{}), LevelView(radians(5.0), radians(3.0))};
  const StripeCourse truth{.theta_rad = 0.3, .rho = -0.2, .width = 0.1};
  const StripeAxes axes(truth);
  const auto px = [&](double along) {
    const Eigen::Vector2d p = axes.at(along, 0.0);
    return pose.camera.project(pose.view.tilted({p.x(), p.y()}));
  };
  const LineFeature level = level_line(line_through(px(-0.3), px(0.4)), pose);
  EXPECT_NEAR(level.rho, -0.2, 1e-9);
  EXPECT_NEAR(level.theta_rad, 0.3, 1e-9);
}

}  // namespace
}  // namespace lineservo::features
