#include "vehicle/floor/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using features::kPi;

void expect_point(const Vector2d& actual, double x, double y) {
  EXPECT_NEAR(actual.x(), x, 1e-12);
  EXPECT_NEAR(actual.y(), y, 1e-12);
}

TEST(Curve, LineRunsFromEndToEnd) {
  const Curve line = Curve::line({1.0, 2.0}, {4.0, 6.0});
  EXPECT_DOUBLE_EQ(line.length_m(), 5.0);
  expect_point(line.at(2.5).p_W, 2.5, 4.0);
  expect_point(line.at(-1.0).p_W, 1.0, 2.0);
  expect_point(line.at(9.0).p_W, 4.0, 6.0);
  EXPECT_NEAR(line.at(1.0).heading_rad, std::atan2(4.0, 3.0), 1e-15);
  EXPECT_EQ(line.at(1.0).curvature_inv_m, 0.0);
}

TEST(Curve, OffsetFromALineIsPositiveToTheLeft) {
  const Curve line = Curve::line({0.0, 0.0}, {2.0, 0.0});
  const CurveProjection left = line.project({0.5, 0.3});
  EXPECT_NEAR(left.arc_length_m, 0.5, 1e-15);
  EXPECT_NEAR(left.signed_offset_m, 0.3, 1e-15);
  EXPECT_NEAR(line.project({0.5, -0.3}).signed_offset_m, -0.3, 1e-15);
  const CurveProjection past = line.project({5.0, 4.0});
  EXPECT_NEAR(past.arc_length_m, 2.0, 1e-15);
  EXPECT_NEAR(past.distance_m, 5.0, 1e-15);
  EXPECT_NEAR(past.signed_offset_m, 4.0, 1e-15);
}

TEST(Curve, ArcFollowsItsCircleBothWays) {
  const Curve left = Curve::arc({2.0, 0.0}, {0.0, 2.0}, {0.0, 0.0}, true);
  EXPECT_NEAR(left.length_m(), kPi, 1e-12);
  expect_point(left.at(kPi / 2.0).p_W, std::sqrt(2.0), std::sqrt(2.0));
  EXPECT_NEAR(left.at(0.0).heading_rad, kPi / 2.0, 1e-12);
  EXPECT_NEAR(std::abs(left.at(kPi).heading_rad), kPi, 1e-12);
  EXPECT_NEAR(left.at(1.0).curvature_inv_m, 0.5, 1e-15);
  const Curve right = Curve::arc({2.0, 0.0}, {0.0, 2.0}, {0.0, 0.0}, false);
  EXPECT_NEAR(right.length_m(), 3.0 * kPi, 1e-12);
  expect_point(right.at(kPi).p_W, 0.0, -2.0);
  EXPECT_NEAR(right.at(1.0).curvature_inv_m, -0.5, 1e-15);
}

TEST(Curve, EqualEndsMakeAWholeCircle) {
  const Curve circle = Curve::arc({0.0, -5.3}, {0.0, -5.3}, {0.0, 0.0}, true);
  EXPECT_NEAR(circle.length_m(), 2.0 * kPi * 5.3, 1e-12);
  expect_point(circle.at(0.5 * circle.length_m()).p_W, 0.0, 5.3);
  expect_point(circle.at(circle.length_m()).p_W, 0.0, -5.3);
  EXPECT_NEAR(circle.project({-6.0, 0.0}).arc_length_m, 0.75 * circle.length_m(), 1e-12);
}

TEST(Curve, OffsetFromAnArcIsRadialAndPositiveToTheLeft) {
  const Curve left = Curve::arc({2.0, 0.0}, {0.0, 2.0}, {0.0, 0.0}, true);
  const CurveProjection inside = left.project({1.0, 1.0});
  EXPECT_NEAR(inside.arc_length_m, kPi / 2.0, 1e-12);
  EXPECT_NEAR(inside.signed_offset_m, 2.0 - std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(left.project({2.0, 2.0}).signed_offset_m, 2.0 - std::sqrt(8.0), 1e-12);
  const Curve right = Curve::arc({0.0, 2.0}, {2.0, 0.0}, {0.0, 0.0}, false);
  EXPECT_NEAR(right.project({1.0, 1.0}).signed_offset_m, std::sqrt(2.0) - 2.0, 1e-12);
}

TEST(Curve, PastAnArcTheNearerEndCounts) {
  const Curve arc = Curve::arc({2.0, 0.0}, {0.0, 2.0}, {0.0, 0.0}, true);
  EXPECT_EQ(arc.project({2.0, -1.0}).arc_length_m, 0.0);
  EXPECT_NEAR(arc.project({2.0, -1.0}).distance_m, 1.0, 1e-12);
  EXPECT_NEAR(arc.project({-1.0, 2.0}).arc_length_m, kPi, 1e-12);
  EXPECT_NEAR(arc.project({-3.0, -3.0}).distance_m, std::sqrt(34.0), 1e-12);
}

TEST(Curve, PolylineCountsArcLengthThroughItsCorners) {
  const Curve bent = Curve::polyline({{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}});
  EXPECT_DOUBLE_EQ(bent.length_m(), 3.0);
  expect_point(bent.at(2.0).p_W, 1.0, 1.0);
  EXPECT_NEAR(bent.project({1.5, 1.25}).arc_length_m, 2.25, 1e-12);
  EXPECT_NEAR(bent.project({1.5, 1.25}).signed_offset_m, -0.5, 1e-12);
}

// The nearest of 20 000 points of the curve is no nearer than the projection, and no further than half a
// step.
TEST(Curve, ProjectionIsTheNearestPoint) {
  const Curve curve = Curve::arc({1.5, 0.0}, {0.0, -1.5}, {0.0, 0.0}, true);
  for (const Vector2d& p_W :
       {Vector2d(0.3, 0.2), Vector2d(1.0, -1.2), Vector2d(-2.0, 1.0), Vector2d(1.4, -0.1)}) {
    double nearest_m = 1e9;
    constexpr int kSteps = 20000;
    for (int i = 0; i <= kSteps; ++i)
      nearest_m = std::min(nearest_m, (curve.at(curve.length_m() * i / kSteps).p_W - p_W).norm());
    const CurveProjection projection = curve.project(p_W);
    EXPECT_LE(projection.distance_m, nearest_m + 1e-12);
    EXPECT_GE(projection.distance_m, nearest_m - 1e-6);
    EXPECT_NEAR((curve.at(projection.arc_length_m).p_W - p_W).norm(), projection.distance_m, 1e-12);
  }
}

TEST(Curve, RefusesWhatIsNoCurve) {
  EXPECT_THROW(Curve::polyline({{0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Curve::polyline({{0.0, 0.0}, {0.0, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Curve::arc({1.0, 0.0}, {0.0, 1.002}, {0.0, 0.0}, true), std::invalid_argument);
  EXPECT_NO_THROW(Curve::arc({1.0, 0.0}, {0.0, 1.0009}, {0.0, 0.0}, true));
  EXPECT_THROW(Curve::arc({0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, true), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
