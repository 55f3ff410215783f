#include "servo/executive/corner.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace lineservo::servo {
namespace {

using features::kPi;
using features::radians;

const Eigen::Vector2d kNode(1.0, -2.0);

TEST(CornerArc, IsThatOfTheSpeedAsLongAsItKeepsToTheEdges) {
  const CornerOptions options{0.03, 0.5, radians(100.0)};
  const CornerArc slow = corner_arc(kPi / 2, 0.1, options);
  EXPECT_NEAR(slow.radius_m, 0.02, 1e-12);  // v² / a
  EXPECT_NEAR(slow.speed_m_s, 0.1, 1e-12);
  const CornerArc fast = corner_arc(-kPi / 2, 1.0, options);
  EXPECT_NEAR(fast.radius_m * (1.0 - std::cos(kPi / 4)), 0.03, 1e-12);
  EXPECT_NEAR(fast.speed_m_s * fast.speed_m_s / fast.radius_m, 0.5, 1e-12);
  EXPECT_GT(corner_arc(kPi / 4, 1.0, options).radius_m, fast.radius_m);  // a gentle bend is flown faster
}

TEST(CornerArc, IsShortenedToWhatIsLeftOfTheWay) {
  const CornerOptions options{0.03, 0.5, radians(100.0)};
  const CornerArc arc{0.1, std::sqrt(0.05)};
  EXPECT_EQ(shortened(arc, kPi / 2, 0.11, options).radius_m, 0.1);
  const CornerArc shorter = shortened(arc, -kPi / 2, 0.06, options);
  EXPECT_NEAR(shorter.radius_m, 0.06, 1e-12);
  EXPECT_NEAR(shorter.speed_m_s, std::sqrt(0.5 * 0.06), 1e-12);
  EXPECT_EQ(shortened(arc, kPi / 2, -0.01, options).speed_m_s, 0.0);
}

class CornerPaths : public ::testing::TestWithParam<double> {
 protected:
  CornerPath path_{kNode, 0.3, GetParam(), 0.1};
};

TEST_P(CornerPaths, IsOneSmoothWay) {
  constexpr double kStep_m = 1e-5;
  for (double way_m = -0.4; way_m < 0.4; way_m += 0.0037) {
    const Eigen::Vector2d step_m = path_.point_m(way_m + kStep_m) - path_.point_m(way_m);
    EXPECT_NEAR(step_m.norm(), kStep_m, 1e-9);
    EXPECT_NEAR(std::remainder(std::atan2(step_m.y(), step_m.x()) - path_.heading_rad(way_m), 2 * kPi), 0.0,
                2e-4);
  }
}

TEST_P(CornerPaths, EveryPlaceIsNearestToItselfAndToWhatLiesBesideIt) {
  for (double way_m = -0.4; way_m < 0.4; way_m += 0.0037) {
    const double heading_rad = path_.heading_rad(way_m);
    const Eigen::Vector2d left(-std::sin(heading_rad), std::cos(heading_rad));
    for (const double beside_m : {-0.02, 0.0, 0.02}) {
      EXPECT_NEAR(path_.nearest_way_m(path_.point_m(way_m) + beside_m * left), way_m, 1e-9) << way_m;
    }
  }
}

TEST_P(CornerPaths, TheMiddleOfTheArcIsTheFurthestFromTheEdges) {
  const Eigen::Vector2d middle_m = path_.point_m(0.0) - kNode;
  const Eigen::Vector2d in(std::cos(0.3), std::sin(0.3));
  const double off_m = std::abs(in.x() * middle_m.y() - in.y() * middle_m.x());
  EXPECT_NEAR(off_m, 0.1 * (1.0 - std::cos(0.5 * GetParam())), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Turns, CornerPaths,
                         ::testing::Values(radians(90.0), radians(-90.0), radians(45.0), radians(-100.0)));

}  // namespace
}  // namespace lineservo::servo
