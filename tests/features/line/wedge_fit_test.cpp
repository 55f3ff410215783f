#include "features/line/wedge_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

/// Border points exactly on both borders of a wedge, every 0.01 from −half to +half along it.
std::vector<BorderPoint> borders_of(const Wedge& wedge, double half_length) {
  std::vector<BorderPoint> points;
  const StripeAxes axes(wedge.course);
  for (double a = -half_length; a <= half_length; a += 0.01) {
    for (const double side : {-0.5, 0.5}) {
      const double across = side * (wedge.course.width + wedge.convergence * a);
      points.push_back({.p_L = axes.at(wedge.at_along + a, across),
                        .normal = -2.0 * side * axes.normal(),
                        .theta_rad = wedge.course.theta_rad,
                        .length = 0.01});
    }
  }
  return points;
}

Wedge truth() {
  return {.course = {.theta_rad = 0.3, .rho = 0.1, .width = 0.2}, .convergence = 0.25, .at_along = 0.0};
}

TEST(WedgeFit, RecoversConvergingBordersExactly) {
  const auto wedge = fit_wedge(borders_of(truth(), 0.3), {0.32, 0.105, 0.19}, -0.3, 0.3);
  ASSERT_TRUE(wedge);
  EXPECT_NEAR(wedge->course.theta_rad, 0.3, 1e-6);
  EXPECT_NEAR(wedge->course.rho, 0.1, 1e-6);
  EXPECT_NEAR(wedge->course.width + wedge->convergence * (0.0 - wedge->at_along), 0.2, 1e-6);
  EXPECT_NEAR(wedge->convergence, 0.25, 1e-6);
  EXPECT_NEAR(wedge->scatter, 0.0, 1e-6);
  EXPECT_NEAR(wedge->support, 2 * 61 * 0.01, 0.0201);
}

TEST(WedgeFit, KeepsParallelBordersParallel) {
  Wedge parallel = truth();
  parallel.convergence = 0.0;
  const auto wedge = fit_wedge(borders_of(parallel, 0.3), {0.28, 0.095, 0.21}, -0.3, 0.3);
  ASSERT_TRUE(wedge);
  EXPECT_NEAR(wedge->convergence, 0.0, 1e-6);
  EXPECT_NEAR(wedge->course.width, 0.2, 1e-6);
}

TEST(WedgeFit, IgnoresBordersOffTheWedge) {
  auto points = borders_of(truth(), 0.3);
  for (int k = 0; k < 12; ++k) {  // a border as of a side arm, 0.08 outside
    BorderPoint stray = points[static_cast<std::size_t>(2 * k + 1)];
    stray.p_L += 0.08 * truth().course.normal();
    points.push_back(stray);
  }
  const auto wedge = fit_wedge(points, {0.31, 0.1, 0.2}, -0.3, 0.3);
  ASSERT_TRUE(wedge);
  EXPECT_NEAR(wedge->course.theta_rad, 0.3, 1e-5);
  EXPECT_NEAR(wedge->course.rho, 0.1, 1e-5);
}

TEST(WedgeFit, RefusesMoreConvergenceThanAllowed) {
  const WedgeOptions below{.max_convergence = 0.24}, above{.max_convergence = 0.26};
  EXPECT_FALSE(fit_wedge(borders_of(truth(), 0.3), {0.3, 0.1, 0.2}, -0.3, 0.3, below));
  EXPECT_TRUE(fit_wedge(borders_of(truth(), 0.3), {0.3, 0.1, 0.2}, -0.3, 0.3, above));
}

TEST(WedgeFit, NeedsBothBorders) {
  auto points = borders_of(truth(), 0.3);
  std::erase_if(points, [](const BorderPoint& p) { return p.normal.dot(truth().course.normal()) > 0.0; });
  EXPECT_FALSE(fit_wedge(points, {0.3, 0.1, 0.2}, -0.3, 0.3));
}

}  // namespace
}  // namespace lineservo::features
