#include "servo/law/motion.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/servo/test_pose.h"

namespace lineservo::servo {
namespace {

using features::kPi;
using features::LineFeature;
using features::radians;
using testing::Pose;

const std::vector<Motion> kMotions = {
    {{0.0, 0.0}, 0.0}, {{1.0, -2.0}, 0.3}, {{-0.4, 0.7}, -2.9}, {{5.0, 0.1}, 7.0}};

void expect_same(const Motion& a, const Motion& b) {
  EXPECT_LT((a.translation_m - b.translation_m).norm(), 1e-12);
  EXPECT_NEAR(a.yaw_rad, b.yaw_rad, 1e-12);
}

TEST(Motion, ComposeByHand) {
  // A metre ahead and a quarter turn to the left, then a metre ahead: that lies one ahead, one left.
  const Motion both = compose({{1.0, 0.0}, kPi / 2}, {{1.0, 0.0}, 0.2});
  expect_same(both, {{1.0, 1.0}, kPi / 2 + 0.2});
}

TEST(Motion, BetweenUndoesCompose) {
  for (const Motion& a : kMotions) {
    for (const Motion& b : kMotions) {
      expect_same(between(a, compose(a, b)), b);
      expect_same(compose(a, between(a, b)), b);
    }
    expect_same(between(a, a), Motion{});
    expect_same(compose(a, Motion{}), a);
    expect_same(compose(Motion{}, a), a);
  }
}

TEST(Motion, ComposeIsAssociative) {
  const Motion &a = kMotions[1], &b = kMotions[2], &c = kMotions[3];
  expect_same(compose(compose(a, b), c), compose(a, compose(b, c)));
}

TEST(Motion, BetweenDoesNotDependOnTheOrigin) {
  const Motion elsewhere{{-3.0, 8.0}, 1.1};
  const Motion &a = kMotions[1], &b = kMotions[2];
  expect_same(between(compose(elsewhere, a), compose(elsewhere, b)), between(a, b));
}

TEST(Motion, FloorPointsAreForwardAndLeft) {
  const Eigen::Vector2d up_and_right_in_the_image = floor_point_m({0.2, -0.6}, 0.5);
  EXPECT_NEAR(up_and_right_in_the_image.x(), 0.3, 1e-15);   // forward
  EXPECT_NEAR(up_and_right_in_the_image.y(), -0.1, 1e-15);  // right
  const features::LevelPoint back = level_point(up_and_right_in_the_image, 0.5);
  EXPECT_NEAR(back.x, 0.2, 1e-15);
  EXPECT_NEAR(back.y, -0.6, 1e-15);
}

TEST(Motion, APointAfterAMotionIsThePointFromThePlaceReached) {
  const Eigen::Vector2d point_W(2.0, -1.0);
  const Pose from{{0.5, 0.2}, 0.4, 0.5};
  for (const Motion& m : kMotions) {
    Pose to = from;
    to.p_W += Eigen::Rotation2Dd(from.heading_rad) * m.translation_m;
    to.heading_rad += m.yaw_rad;
    const Eigen::Vector2d moved = after(m, testing::in_heading_frame(from, point_W));
    EXPECT_LT((moved - testing::in_heading_frame(to, point_W)).norm(), 1e-12);
  }
}

/// A motion and the line that is looked at from its start.
struct LineCase {
  double line_heading_deg, start_heading_deg;
  Motion motion;
};

class LineAfter : public ::testing::TestWithParam<LineCase> {};

INSTANTIATE_TEST_SUITE_P(Motions, LineAfter,
                         ::testing::Values(LineCase{0, 0, {{0.1, 0.0}, 0.0}},  // along the line
                                           LineCase{0, 0, {{0.0, 0.1}, 0.0}},  // away from it
                                           LineCase{0, 0, {{0.0, 0.0}, 0.3}},  // on the spot
                                           LineCase{0, 20, {{0.2, -0.1}, -0.5}},
                                           LineCase{35, 10, {{-0.2, 0.15}, 0.4}},
                                           LineCase{-60, 0, {{0.3, 0.3}, 0.2}}));

TEST_P(LineAfter, IsTheLineSeenFromThePlaceReached) {
  const LineCase c = GetParam();
  const double along_rad = radians(c.line_heading_deg);
  const Eigen::Vector2d a_W(0.3, -0.2), b_W = a_W + Eigen::Vector2d(std::cos(along_rad), std::sin(along_rad));
  const Pose from{{0.1, 0.1}, radians(c.start_heading_deg), 0.6};
  Pose to = from;
  to.p_W += Eigen::Rotation2Dd(from.heading_rad) * c.motion.translation_m;
  to.heading_rad += c.motion.yaw_rad;
  const LineFeature moved = after(c.motion, testing::seen_line(from, a_W, b_W), 0.6);
  const LineFeature expected = testing::seen_line(to, a_W, b_W);
  EXPECT_NEAR(moved.rho, expected.rho, 1e-12);
  EXPECT_NEAR(moved.theta_rad, expected.theta_rad, 1e-12);
}

/// The tangent of a circle about `centre_W`, passed counter-clockwise, at the place nearest to the vehicle.
LineFeature seen_arc(const Pose& pose, const Eigen::Vector2d& centre_W, double radius_m) {
  const Eigen::Vector2d out = (pose.p_W - centre_W).normalized();
  const Eigen::Vector2d nearest_W = centre_W + radius_m * out, along(-out.y(), out.x());
  LineFeature line = testing::seen_line(pose, nearest_W - along, nearest_W + along);
  line.curvature = -pose.height_m / radius_m;  // to the left: against the normal
  return line;
}

TEST(Motion, ALineThatBendsTurnsUnderTheVehicle) {
  const Eigen::Vector2d centre_W(0.0, 1.5);
  const Pose from{{0.0, 0.02}, 0.03, 0.5};
  for (const double forward_m : {0.02, 0.05, 0.1}) {
    const Motion motion{{forward_m, 0.01}, 0.04};
    Pose to = from;
    to.p_W += Eigen::Rotation2Dd(from.heading_rad) * motion.translation_m;
    to.heading_rad += motion.yaw_rad;
    const LineFeature moved = after(motion, seen_arc(from, centre_W, 1.5), 0.5);
    const LineFeature expected = seen_arc(to, centre_W, 1.5);
    const double third_order =
        2.0 * std::pow(forward_m / 0.5, 3.0) * std::pow(0.5 / 1.5, 2.0) + 5e-4 * forward_m;
    EXPECT_NEAR(moved.rho, expected.rho, third_order) << forward_m;
    EXPECT_NEAR(moved.theta_rad, expected.theta_rad, third_order) << forward_m;
  }
}

TEST(Motion, ALineKeepsTheBranchNearestToItsOldAngle) {
  // θ = 80° and a left turn of 20°: 100° is told, not the other spelling −80° with −ρ.
  LineFeature line;
  line.rho = 0.2;
  line.theta_rad = radians(80.0);
  const LineFeature turned = after({{0.0, 0.0}, radians(20.0)}, line, 0.5);
  EXPECT_NEAR(turned.theta_rad, radians(100.0), 1e-12);
  EXPECT_NEAR(turned.rho, 0.2, 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
