#include "servo/task/point_task.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/servo/task/task_properties.h"

namespace lineservo::servo {
namespace {

using testing::Pose;
using Heading = PointTask::Heading;

constexpr double kHeight_m = 0.5;
constexpr double kGain = 1.1;
constexpr AdaptiveGain kConstant{kGain, kGain, 0.0};
const Eigen::Vector2d kNode_W(0.0, 0.0), kAhead_W(1.0, 0.0);

/// The point task over the floor's origin, with a line along x through it.
struct Scene {
  explicit Scene(Heading heading)
      : point(kConstant, heading), dimension(heading == Heading::on_line ? 4 : 3) {}

  TaskSolution solve(const Pose& pose, double yaw_rate_rad_s,
                     const Eigen::Vector2d& drift_H_m_s = Eigen::Vector2d::Zero()) {
    const double theta_rad = testing::seen_line(pose, kNode_W, kAhead_W).theta_rad;
    return point.solve(testing::seen_point(pose, kNode_W), theta_rad, pose.height_m, kHeight_m,
                       yaw_rate_rad_s, drift_H_m_s);
  }
  testing::TaskUnderTest under_test() {
    return {point.task(),
            dimension,
            {{0.0, 0.0}, 0.0, kHeight_m},
            kGain,
            [this](const Pose& pose, double yaw_rate_rad_s) { return solve(pose, yaw_rate_rad_s); }};
  }

  PointTask point;
  int dimension;
};

class PointTaskTest : public ::testing::TestWithParam<Heading> {
 protected:
  Scene scene{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Headings, PointTaskTest, ::testing::Values(Heading::free, Heading::on_line),
                         [](const auto& tested) {
                           return tested.param == Heading::free ? "Free" : "OnLine";
                         });

TEST_P(PointTaskTest, HoldsTheTaskProperties) {
  testing::expect_task_properties(scene.under_test(), testing::poses_around_origin());
}

TEST_P(PointTaskTest, InteractionMatrixInClosedForm) {
  // ẋ = (v_left − x·v_up)/h − y·ω,   ẏ = (v_forward − y·v_up)/h + x·ω,   d/dt ln(Z/Z*) = v_up/h,   θ̇ = ω
  const double x = 0.2, y = -0.35, h = 0.8;
  scene.point.solve({x, y}, 0.1, h, kHeight_m, 0.0, {0.0, 0.0});
  Eigen::Matrix4d J;
  J << 0, 1 / h, -x / h, -y,  //
      1 / h, 0, -y / h, x,    //
      0, 0, 1 / h, 0,         //
      0, 0, 0, 1;
  EXPECT_LT((scene.point.task().jacobian() - J.topRows(scene.dimension)).norm(), 1e-12)
      << scene.point.task().jacobian();
}

TEST_P(PointTaskTest, FirstStepGoesToThePoint) {
  const VelocityCommand behind_left = scene.solve({{-0.1, 0.1}, 0.0, kHeight_m}, 0.0).command;
  EXPECT_GT(behind_left.forward_m_s, 0.01);
  EXPECT_LT(behind_left.left_m_s, -0.01);
  const VelocityCommand ahead_right = scene.solve({{0.1, -0.1}, 0.0, kHeight_m}, 0.0).command;
  EXPECT_LT(ahead_right.forward_m_s, -0.01);
  EXPECT_GT(ahead_right.left_m_s, 0.01);
  EXPECT_LT(scene.solve({{0.0, 0.0}, 0.0, 0.6}, 0.0).command.up_m_s, -0.01);
  EXPECT_GT(scene.solve({{0.0, 0.0}, 0.0, 0.4}, 0.0).command.up_m_s, 0.01);
}

TEST_P(PointTaskTest, DriftIsCancelledExactly) {
  // A drift (forward, left) moves the point by (d_left, d_forward) / h; the error's rate has to stay −λ·e.
  const Eigen::Vector2d drift_H_m_s(0.05, -0.03);
  for (const Pose& pose : testing::poses_around_origin()) {
    const Eigen::Vector4d q = testing::vector_of(scene.solve(pose, 0.0, drift_H_m_s).command);
    Eigen::VectorXd rate = scene.point.task().jacobian() * q;
    rate[0] += drift_H_m_s.y() / pose.height_m;
    rate[1] += drift_H_m_s.x() / pose.height_m;
    EXPECT_LT((rate + kGain * scene.point.task().error()).norm(), 1e-10);
  }
}

TEST_P(PointTaskTest, AtTheGoalADriftIsAnsweredByItsOpposite) {
  const VelocityCommand c = scene.solve({{0.0, 0.0}, 0.0, kHeight_m}, 0.0, {0.05, -0.03}).command;
  EXPECT_NEAR(c.forward_m_s, -0.05, 1e-12);
  EXPECT_NEAR(c.left_m_s, 0.03, 1e-12);
}

TEST_P(PointTaskTest, AnImpossibleSceneIsNotValid) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(scene.point.solve({kNaN, 0.0}, 0.0, 0.5, 0.5, 0.0, {0.0, 0.0}).valid);
  EXPECT_FALSE(scene.point.solve({0.0, 0.0}, 0.0, 0.0, 0.5, 0.0, {0.0, 0.0}).valid);
  EXPECT_FALSE(scene.point.solve({0.0, 0.0}, 0.0, 0.5, 0.5, 0.0, {kNaN, 0.0}).valid);
  EXPECT_TRUE(scene.point.solve({0.0, 0.0}, 0.0, 0.5, 0.5, 0.0, {0.0, 0.0}).valid);
}

TEST(PointTask, OnTheLineTheHeadingIsBroughtToTheLine) {
  Scene scene(Heading::on_line);
  EXPECT_NEAR(scene.solve({{0.0, 0.0}, 0.2, kHeight_m}, 0.0).command.yaw_rate_rad_s, -kGain * 0.2, 1e-12);
  EXPECT_NEAR(scene.solve({{0.0, 0.0}, -0.2, kHeight_m}, 0.0).command.yaw_rate_rad_s, kGain * 0.2, 1e-12);
}

TEST(PointTask, OnTheLineNoSecondaryYawIsLeft) {
  Scene scene(Heading::on_line);
  const Pose pose{{0.1, 0.05}, 0.1, kHeight_m};
  const Eigen::Vector4d without = testing::vector_of(scene.solve(pose, 0.0).command);
  EXPECT_LT((testing::vector_of(scene.solve(pose, 0.6).command) - without).norm(), 1e-12);
}

TEST(PointTask, AboveThePointTheYawRateIsKept) {
  Scene scene(Heading::free);
  const VelocityCommand c = scene.solve({{0.0, 0.0}, 0.5, kHeight_m}, 0.6).command;
  EXPECT_NEAR(c.yaw_rate_rad_s, 0.6, 1e-12);
  EXPECT_NEAR(c.forward_m_s, 0.0, 1e-12);
  EXPECT_NEAR(c.left_m_s, 0.0, 1e-12);
}

TEST(PointTask, AsideOfThePointTheFreeYawCirclesIt) {
  // In the null space the vehicle keeps the point where it is in the image: with p the point in H, a yaw ω
  // goes with v = −ω ẑ × p, along the circle about the point.
  Scene scene(Heading::free);
  const Pose pose{{0.1, 0.2}, 0.0, kHeight_m};
  const Eigen::Vector2d p_H = testing::in_heading_frame(pose, kNode_W);
  const Eigen::Vector4d added =
      testing::vector_of(scene.solve(pose, 0.6).command) - testing::vector_of(scene.solve(pose, 0.0).command);
  EXPECT_GT(added[3], 0.1);
  EXPECT_NEAR(added[0], added[3] * p_H.y(), 1e-12);
  EXPECT_NEAR(added[1], -added[3] * p_H.x(), 1e-12);
  EXPECT_NEAR(added[2], 0.0, 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
