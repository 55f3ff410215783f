#include "features/line/image_line.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

TEST(ImageLine, ThetaLiesInItsHalfTurnAndTheLineStays) {
  const ImageLine line = canonical_line(50.0, radians(120.0));
  EXPECT_NEAR(line.theta_rad, radians(-60.0), 1e-12);
  EXPECT_NEAR(line.rho_px, -50.0, 1e-12);
  EXPECT_NEAR(canonical_line(50.0, radians(-90.0)).theta_rad, radians(90.0), 1e-12);
  EXPECT_NEAR(canonical_line(50.0, radians(-90.0)).rho_px, -50.0, 1e-12);
  EXPECT_NEAR(canonical_line(50.0, radians(90.0)).rho_px, 50.0, 1e-12);
}

TEST(ImageLine, ThroughTwoPointsEitherWayRound) {
  for (const bool swapped : {false, true}) {
    const PixelPoint a{100.0, 0.0}, b{100.0, 50.0};
    const ImageLine line = swapped ? line_through(b, a) : line_through(a, b);
    EXPECT_NEAR(line.rho_px, 100.0, 1e-9);
    EXPECT_NEAR(line.theta_rad, 0.0, 1e-12);
    EXPECT_EQ(line.end.y, 0.0);  // forward is up
  }
  const ImageLine level = line_through({0.0, 30.0}, {10.0, 30.0});
  EXPECT_NEAR(level.theta_rad, radians(90.0), 1e-12);
  EXPECT_NEAR(level.rho_px, 30.0, 1e-9);
  const ImageLine left = line_through({0.0, 10.0}, {10.0, 20.0});  // x − y = −10
  EXPECT_NEAR(left.theta_rad, radians(-45.0), 1e-12);
  EXPECT_NEAR(left.rho_px, -10.0 / std::sqrt(2.0), 1e-9);
}

TEST(ImageLine, DifferenceTakesTheNearerBranch) {
  const LineDifference d =
      difference(canonical_line(100.0, radians(89.5)), canonical_line(-101.0, radians(-89.5)));
  EXPECT_NEAR(d.rho_px, 1.0, 1e-9);  // −100 against −101
  EXPECT_NEAR(d.theta_rad, radians(-1.0), 1e-12);
}

TEST(ImageLine, StretchRunsFromOuterEdgeToOuterEdge) {
  const auto up = stretch_in_image(canonical_line(10.0, 0.0), {64, 48});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->first, -47.5, 1e-9);  // along is −y
  EXPECT_NEAR(up->second, 0.5, 1e-9);
  EXPECT_TRUE(stretch_in_image(canonical_line(63.4, 0.0), {64, 48}));
  EXPECT_FALSE(stretch_in_image(canonical_line(63.6, 0.0), {64, 48}));
  EXPECT_FALSE(stretch_in_image(canonical_line(-20.0, radians(45.0)), {64, 48}));
}

TEST(ImageLine, RescalingKeepsThePixelsOuterEdges) {
  // The line x' = 19.5 of an image half as wide is x = 39.5 + ½: (19.5 + ½) · 2 − ½.
  const ImageLine up = rescaled(canonical_line(19.5, 0.0), {320, 480}, {640, 480});
  EXPECT_NEAR(up.rho_px, 39.5, 1e-9);
  EXPECT_NEAR(up.theta_rad, 0.0, 1e-12);
}

TEST(ImageLine, RescalingUnevenlyMovesEveryPointWithTheImage) {
  ImageLine line = line_through({20.0, 100.0}, {90.0, 10.0});
  line.width_px = 8.0;
  line.covariance = Eigen::Vector2d(0.04, 1e-6).asDiagonal();
  const ImageLine image = rescaled(line, {400, 400}, {640, 480});
  for (const PixelPoint& p : {line.begin, line.end})
    EXPECT_NEAR(image.across({(p.x + 0.5) * 1.6 - 0.5, (p.y + 0.5) * 1.2 - 0.5}), 0.0, 1e-9);
  EXPECT_NEAR(image.along(image.begin), image.along({(20.5) * 1.6 - 0.5, 100.5 * 1.2 - 0.5}), 1e-9);
  EXPECT_GT(image.width_px, 8.0 * 1.2);
  EXPECT_LT(image.width_px, 8.0 * 1.6);
  EXPECT_GT(image.covariance(0, 0), 0.04);
  EXPECT_GT(image.covariance.determinant(), 0.0);
}

}  // namespace
}  // namespace lineservo::features
