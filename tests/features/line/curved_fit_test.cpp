#include "features/line/curved_fit.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"
#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

std::vector<EdgePoint> borders_of(const CurvedCourse& course, double half_length, int per_border) {
  std::vector<EdgePoint> points;
  for (int k = 0; k < per_border; ++k) {
    const double along = half_length * (2.0 * k / (per_border - 1) - 1.0);
    for (const double side : {-1.0, 1.0})
      points.push_back({course.at(along, 0.5 * side * course.width_at(along)), side});
  }
  return points;
}

const CurvedCourse kArc{.foot = {0.1, 0.05}, .theta_rad = 0.2, .width = 0.3, .curvature = 0.4};

TEST(CurvedCourse, ItsPointsLieOnTheCircle) {
  const Eigen::Vector2d centre = kArc.foot + kArc.normal() / 0.4;
  for (const double along : {-1.0, -0.2, 0.0, 0.7}) {
    for (const double across : {-0.15, 0.0, 0.15}) {
      const Eigen::Vector2d p = kArc.at(along, across);
      EXPECT_NEAR((p - centre).norm(), 2.5 - across, 1e-12);
      EXPECT_NEAR(kArc.across(p), across, 1e-12);
      EXPECT_NEAR(kArc.along(p), along, 1e-12);
      const Eigen::Vector2d to_centre = (centre - p).normalized();
      EXPECT_NEAR(std::cos(kArc.theta_at(along)), to_centre.x(), 1e-12);
      EXPECT_NEAR(std::sin(kArc.theta_at(along)), to_centre.y(), 1e-12);
    }
  }
}

TEST(CurvedCourse, WithoutCurvatureItIsALine) {
  CurvedCourse course = kArc;
  course.curvature = 0.0;
  const Eigen::Vector2d p = course.at(0.3, -0.1);
  EXPECT_TRUE(p.isApprox(course.foot + 0.3 * course.forward() - 0.1 * course.normal()));
  EXPECT_NEAR(course.along(p), 0.3, 1e-12);
  EXPECT_NEAR(course.across(p), -0.1, 1e-12);
}

TEST(CurvedFit, RecoversAnExactArcFromAStraightStart) {
  CurvedCourse start = kArc;
  start.curvature = 0.0;
  start.theta_rad += 0.02;
  start.foot += Eigen::Vector2d(0.01, 0.01);
  const auto fit =
      fit_borders(borders_of(kArc, 0.6, 60), start, {.width = true, .curvature = true}, 0.2, 0.01);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.curvature, 0.4, 1e-6);
  EXPECT_NEAR(fit->course.width, 0.3, 1e-6);
  EXPECT_NEAR(fit->course.across(kArc.at(0.3, 0.1)), 0.1, 1e-6);
}

TEST(CurvedFit, RecoversATaper) {
  CurvedCourse wedge = kArc;
  wedge.curvature = 0.0;
  wedge.taper = 0.1;
  CurvedCourse start = wedge;
  start.taper = 0.0;
  const auto fit = fit_borders(borders_of(wedge, 0.6, 60), start, {.width = true, .taper = true}, 0.2, 0.01);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.taper, 0.1, 1e-9);
  EXPECT_NEAR(fit->course.theta_rad, 0.2, 1e-9);
  EXPECT_GT(fit->taper_sigma, -1e-12);
}

TEST(CurvedFit, AThirdOfTheBorderFarOffMovesNothing) {
  CurvedCourse straight = kArc;
  straight.curvature = 0.0;
  std::vector<EdgePoint> points = borders_of(straight, 0.6, 90);
  for (std::size_t i = 0; i < points.size(); i += 3) points[i].p += 0.05 * straight.normal();
  CurvedCourse start = straight;
  start.theta_rad += 0.01;
  const auto fit = fit_borders(points, start, {}, 0.1, 0.002);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->course.theta_rad, 0.2, 1e-6);
  EXPECT_NEAR(fit->course.across(straight.foot), 0.0, 1e-6);
}

TEST(CurvedFit, ItsCovarianceIsWhatAGridOfNoisyStripesShows) {
  CurvedCourse straight = kArc;
  straight.curvature = 0.0;
  test::TestRandom random(3);
  double squares = 0.0, stated = 0.0;
  constexpr int trials = 200;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<EdgePoint> points = borders_of(straight, 0.6, 40);
    for (EdgePoint& point : points) point.p += random.uniform(-0.01, 0.01) * straight.normal();
    const auto fit = fit_borders(points, straight, {}, 0.05, 0.02);
    ASSERT_TRUE(fit);
    squares += std::pow(fit->course.theta_rad - 0.2, 2) / trials;
    stated += fit->covariance(1, 1) / trials;
  }
  EXPECT_GT(stated / squares, 0.6);
  EXPECT_LT(stated / squares, 1.6);
}

TEST(CurvedFit, TooFewPointsGiveNone) {
  EXPECT_FALSE(fit_borders(borders_of(kArc, 0.6, 3), kArc, {}, 0.1, 0.01));
  EXPECT_FALSE(fit_borders({}, kArc, {}, 0.1, 0.01));
}

}  // namespace
}  // namespace lineservo::features
