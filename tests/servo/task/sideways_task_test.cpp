#include "servo/task/sideways_task.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/servo/task/task_properties.h"

namespace lineservo::servo {
namespace {

using features::LevelPoint;
using testing::Pose;

constexpr double kHeight_m = 0.5;
constexpr double kGain = 0.9;
constexpr AdaptiveGain kConstant{kGain, kGain, 0.0};

/// The task over one floor point: below the goal's pose, as a centroid is, or ahead of it, as a target is.
struct Scene {
  explicit Scene(double ahead_m) : point_W(ahead_m, 0.0) {}

  TaskSolution solve(const Pose& pose, const KnownMotion& motion) {
    return sideways.solve(testing::seen_point(pose, point_W), pose.height_m, kHeight_m, motion);
  }
  testing::TaskUnderTest under_test() {
    return {
        sideways.task(),
        2,
        {{0.0, 0.0}, 0.0, kHeight_m},
        kGain,
        [this](const Pose& pose, double forward_m_s) { return solve(pose, {.forward_m_s = forward_m_s}); },
        false};
  }

  Eigen::Vector2d point_W;
  SidewaysTask sideways{kConstant};
};

class SidewaysTaskTest : public ::testing::TestWithParam<double> {
 protected:
  Scene scene{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Points, SidewaysTaskTest, ::testing::Values(0.0, 0.25));

TEST_P(SidewaysTaskTest, HoldsTheTaskProperties) {
  testing::expect_task_properties(scene.under_test(), testing::poses_around_origin());
}

TEST_P(SidewaysTaskTest, FirstStepGoesToThePoint) {
  const auto first = [&](const Pose& pose) { return scene.solve(pose, {}).command; };
  EXPECT_LT(first({{0.0, 0.1}, 0.0, kHeight_m}).left_m_s, -0.01);  // left of it: to the right
  EXPECT_GT(first({{0.0, -0.1}, 0.0, kHeight_m}).left_m_s, 0.01);
  EXPECT_LT(first({{0.0, 0.0}, 0.0, 0.6}).up_m_s, -0.01);  // too high: down
  EXPECT_GT(first({{0.0, 0.0}, 0.0, 0.4}).up_m_s, 0.01);
}

TEST_P(SidewaysTaskTest, TheForwardSpeedAndTheYawPassAsTheyAre) {
  for (const Pose& pose : testing::poses_around_origin()) {
    const VelocityCommand c = scene.solve(pose, {.forward_m_s = 0.3, .yaw_rate_rad_s = -0.2}).command;
    EXPECT_NEAR(c.forward_m_s, 0.3, 1e-12);
    EXPECT_NEAR(c.yaw_rate_rad_s, -0.2, 1e-12);
  }
}

TEST_P(SidewaysTaskTest, DriftAndYawAreFedForward) {
  // With both at work the point still moves as ẋ = −λ·x: the finite difference of the true picture.
  constexpr double kStep_s = 1e-6, kDrift_m_s = 0.04;
  for (const Pose& pose : testing::poses_around_origin()) {
    const VelocityCommand c = scene.solve(pose, {.yaw_rate_rad_s = 0.3, .drift_m_s = kDrift_m_s}).command;
    const auto x_after = [&](double dt_s) {
      const VelocityCommand real{c.forward_m_s, c.left_m_s + kDrift_m_s, c.up_m_s, c.yaw_rate_rad_s};
      return testing::seen_point(testing::moved(pose, real, dt_s), scene.point_W).x;
    };
    const double rate = (x_after(kStep_s) - x_after(-kStep_s)) / (2.0 * kStep_s);
    EXPECT_NEAR(rate, -kGain * testing::seen_point(pose, scene.point_W).x, 1e-6);
  }
}

TEST(SidewaysTask, InteractionMatrixInClosedForm) {
  // ẋ = (v_left − x·v_up) / h,   d/dt ln(Z/Z*) = v_up / h
  SidewaysTask sideways(kConstant);
  const double x = 0.2, h = 0.8;
  sideways.solve({x, -0.3}, h, kHeight_m, {});
  Eigen::Matrix<double, 2, 4> J;
  J << 0, 1, -x, 0,  //
      0, 0, 1, 0;
  J /= h;
  EXPECT_LT((sideways.task().jacobian() - J).norm(), 1e-12) << sideways.task().jacobian();
}

TEST(SidewaysTask, AnImpossibleSceneIsNotValid) {
  SidewaysTask sideways(kConstant);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(sideways.solve({kNaN, 0.0}, 0.5, 0.5, {}).valid);
  EXPECT_FALSE(sideways.solve({0.1, kNaN}, 0.5, 0.5, {}).valid);
  EXPECT_FALSE(sideways.solve({0.1, 0.0}, 0.0, 0.5, {}).valid);
  EXPECT_FALSE(sideways.solve({0.1, 0.0}, 0.5, 0.5, {.yaw_rate_rad_s = kNaN}).valid);
  EXPECT_TRUE(sideways.solve({0.1, 0.0}, 0.5, 0.5, {}).valid);  // and it recovers
}

}  // namespace
}  // namespace lineservo::servo
