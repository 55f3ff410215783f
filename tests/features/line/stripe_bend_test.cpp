#include "features/line/stripe_bend.h"

#include <gtest/gtest.h>

#include "features/stripe_perception.h"
#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

using test::Pose;
using test::TestMask;

/// The mask of a ring of radius R about (0, R): a line that passes the origin along +x and bends to the left;
/// R < 0 bends to the right.
TestMask ring(const MaskGeometry& geometry, const Pose& pose, double radius_m, double width_m) {
  TestMask mask(geometry.width_px(), geometry.height_px());
  const Eigen::Vector2d centre(0.0, radius_m);
  test::for_each_pixel(geometry, pose, [&](int x, int y, const Eigen::Vector2d& p_W) {
    mask.set(x, y, std::abs((p_W - centre).norm() - std::abs(radius_m)) <= 0.5 * width_m);
  });
  return mask;
}

class StripeBend : public testing::Test {
 protected:
  const LineFeature* follow(const TestMask& mask, const Pose& pose) {
    const StripeFeatures& seen = perception_.observe(mask.view(), pose.view());
    return seen.lines.empty() ? nullptr : &seen.lines.front();
  }
  MaskGeometry geometry_{CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize};
  StripePerception perception_{geometry_};
};

// To the left is against the normal of a line straight ahead: κ_L = −h / R. The tangent is that of the circle
// through the foot: offset and angle of the vehicle against it.
TEST_F(StripeBend, TangentAndCurvatureOfAnArc) {
  for (const double radius_m : {1.5, -1.5, 5.3, -5.3}) {
    for (const double left_m : {-0.04, 0.0, 0.05}) {
      for (const double heading_rad : {-0.1, 0.0, 0.1}) {
        const Pose pose{.x_m = 0.0, .y_m = left_m, .height_m = 0.5, .heading_rad = heading_rad};
        const LineFeature* line = follow(ring(geometry_, pose, radius_m, 0.1), pose);
        ASSERT_NE(line, nullptr);
        EXPECT_NEAR(line->rho * pose.height_m, left_m, 0.0015) << radius_m << ' ' << heading_rad;
        EXPECT_NEAR(line->theta_rad, heading_rad, 0.012) << radius_m << ' ' << left_m;
        EXPECT_NEAR(line->curvature, -pose.height_m / radius_m, 0.02) << left_m << ' ' << heading_rad;
      }
    }
  }
}

TEST_F(StripeBend, AStraightStripeHasNone) {
  for (const double width_m : {0.05, 0.1, 0.36}) {
    for (const double heading_rad : {-0.3, 0.0, 0.017, 0.2}) {
      const Pose pose{.y_m = 0.03, .height_m = 0.5, .heading_rad = heading_rad};
      const LineFeature* line = follow(test::draw(geometry_, pose, test::straight_floor(width_m)), pose);
      ASSERT_NE(line, nullptr);
      EXPECT_EQ(line->curvature, 0.0) << width_m << ' ' << heading_rad;
    }
  }
}

TEST_F(StripeBend, SideArmsBendNothing) {
  for (const double width_m : {0.05, 0.36}) {
    for (const double ahead_m : {-0.3, -0.1, 0.0, 0.1, 0.2, 0.35}) {
      const Pose pose{.x_m = -ahead_m, .y_m = 0.01, .height_m = 0.5, .heading_rad = 0.02};
      const test::Floor floor = test::node_floor({test::kAhead, test::kBehind, test::kLeft}, width_m);
      const LineFeature* line = follow(test::draw(geometry_, pose, floor), pose);
      ASSERT_NE(line, nullptr);
      EXPECT_EQ(line->curvature, 0.0) << width_m << ' ' << ahead_m;
    }
  }
}

}  // namespace
}  // namespace lineservo::features
