#include "servo/task/line_task.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/servo/task/task_properties.h"

namespace lineservo::servo {
namespace {

using features::LineFeature;
using features::radians;
using testing::Pose;

constexpr double kHeight_m = 0.5;
constexpr double kGain = 0.8;
constexpr AdaptiveGain kConstant{kGain, kGain, 0.0};
const Eigen::Vector2d kBehind_W(-1.0, 0.0), kAhead_W(1.0, 0.0);  // the line is the x axis of the floor

/// The line task over the x axis of the floor.
struct Scene {
  LineTask line{kConstant};

  TaskSolution solve(const Pose& pose, double forward_m_s, double drift_m_s = 0.0) {
    const LineFeature seen = testing::seen_line(pose, kBehind_W, kAhead_W);
    return line.solve(seen.rho, seen.theta_rad, pose.height_m, kHeight_m, forward_m_s, drift_m_s);
  }
  testing::TaskUnderTest under_test() {
    return {
        line.task(), 3, {{0.3, 0.0}, 0.0, kHeight_m}, kGain, [this](const Pose& pose, double forward_m_s) {
          return solve(pose, forward_m_s);
        }};
  }
};

TEST(LineTask, HoldsTheTaskProperties) {
  Scene scene;
  testing::expect_task_properties(scene.under_test(), testing::poses_around_origin());
}

TEST(LineTask, InteractionMatrixInClosedForm) {
  // ρ̇ = (sinθ·v_forward + cosθ·v_left − ρ·v_up) / h,   θ̇ = ω,   d/dt ln(Z/Z*) = v_up / h
  LineTask line(kConstant);
  const double rho = 0.3, theta_rad = 0.4, height_m = 0.7;
  line.solve(rho, theta_rad, height_m, kHeight_m, 0.0, 0.0);
  Eigen::Matrix<double, 3, 4> J;
  J << std::sin(theta_rad), std::cos(theta_rad), -rho, 0,  //
      0, 0, 0, height_m,                                   //
      0, 0, 1, 0;
  J /= height_m;
  EXPECT_LT((line.task().jacobian() - J).norm(), 1e-12) << line.task().jacobian();
}

TEST(LineTask, FirstStepGoesToTheLine) {
  Scene scene;
  const auto first = [&](const Pose& pose) { return scene.solve(pose, 0.0).command; };
  EXPECT_LT(first({{0.0, 0.1}, 0.0, kHeight_m}).left_m_s, -0.01);  // left of the line: to the right
  EXPECT_GT(first({{0.0, -0.1}, 0.0, kHeight_m}).left_m_s, 0.01);
  EXPECT_LT(first({{0.0, 0.0}, 0.2, kHeight_m}).yaw_rate_rad_s, -0.01);  // turned to the left: clockwise
  EXPECT_GT(first({{0.0, 0.0}, -0.2, kHeight_m}).yaw_rate_rad_s, 0.01);
  EXPECT_LT(first({{0.0, 0.0}, 0.0, 0.6}).up_m_s, -0.01);  // too high: down
  EXPECT_GT(first({{0.0, 0.0}, 0.0, 0.4}).up_m_s, 0.01);
}

TEST(LineTask, OffsetInMetresAndHeadingFallAtTheGain) {
  Scene scene;
  const VelocityCommand c = scene.solve({{0.0, 0.1}, 0.0, kHeight_m}, 0.0).command;
  EXPECT_NEAR(c.left_m_s, -kGain * 0.1, 1e-12);
  EXPECT_NEAR(scene.solve({{0.0, 0.0}, 0.2, kHeight_m}, 0.0).command.yaw_rate_rad_s, -kGain * 0.2, 1e-12);
}

TEST(LineTask, ForwardSpeedIsKeptOnTheLine) {
  Scene scene;
  const VelocityCommand c = scene.solve({{2.0, 0.0}, 0.0, kHeight_m}, 0.7).command;
  EXPECT_NEAR(c.forward_m_s, 0.7, 1e-12);
  EXPECT_NEAR(c.left_m_s, 0.0, 1e-12);
  EXPECT_NEAR(c.yaw_rate_rad_s, 0.0, 1e-12);
}

TEST(LineTask, ForwardSpeedIsProjectedOntoATurnedLine) {
  // Null space: the unit vector along the line, (cosθ, −sinθ). What is kept of v·(1, 0) is v·cosθ along it.
  Scene scene;
  const double theta_rad = radians(30.0), speed_m_s = 0.5;
  const Pose pose{{0.0, 0.0}, theta_rad, kHeight_m};  // heading left of the line by θ
  const Eigen::Vector4d added = testing::vector_of(scene.solve(pose, speed_m_s).command) -
                                testing::vector_of(scene.solve(pose, 0.0).command);
  EXPECT_NEAR(added[0], speed_m_s * std::cos(theta_rad) * std::cos(theta_rad), 1e-12);
  EXPECT_NEAR(added[1], -speed_m_s * std::cos(theta_rad) * std::sin(theta_rad), 1e-12);
}

TEST(LineTask, DriftAcrossTheLineIsCancelledExactly) {
  // With drift d across the line the error's rate is J·q̇ + (d/h, 0, 0); it has to stay −λ·e.
  Scene scene;
  const double drift_m_s = 0.07;
  for (const Pose& pose : testing::poses_around_origin()) {
    const Eigen::Vector4d q = testing::vector_of(scene.solve(pose, 0.2, drift_m_s).command);
    const Eigen::Vector3d by_drift(drift_m_s / pose.height_m, 0.0, 0.0);
    const Eigen::VectorXd rate = scene.line.task().jacobian() * q + by_drift;
    EXPECT_LT((rate + kGain * scene.line.task().error()).norm(), 1e-10);
  }
}

TEST(LineTask, OnTheLineADriftIsAnsweredByItsOpposite) {
  Scene scene;
  EXPECT_NEAR(scene.solve({{0.0, 0.0}, 0.0, kHeight_m}, 0.2, 0.07).command.left_m_s, -0.07, 1e-12);
}

TEST(LineTask, ABendIsTurnedIntoExactly) {
  // θ̇ = ω + κv: with the bend told, the rate of the error stays −λ·e.
  Scene scene;
  const LineFeature seen = testing::seen_line({{0.0, 0.05}, 0.1, kHeight_m}, kBehind_W, kAhead_W);
  const double bend_rad_s = -0.4;
  const TaskSolution s =
      scene.line.solve(seen.rho, seen.theta_rad, kHeight_m, kHeight_m, 0.3, 0.0, bend_rad_s);
  const Eigen::VectorXd rate =
      scene.line.task().jacobian() * testing::vector_of(s.command) + Eigen::Vector3d(0.0, bend_rad_s, 0.0);
  EXPECT_LT((rate + kGain * scene.line.task().error()).norm(), 1e-10);
  EXPECT_NEAR(scene.line.solve(0.0, 0.0, kHeight_m, kHeight_m, 0.3, 0.0, bend_rad_s).command.yaw_rate_rad_s,
              0.4, 1e-12);
}

TEST(LineTask, TheInteractionMatrixIsTakenWhereItIsAsked) {
  const double rho = 0.3, theta_rad = 0.4, height_m = 0.7;
  const auto jacobian_of = [&](InteractionMatrix matrix) {
    LineTask line(kConstant, matrix);
    EXPECT_TRUE(line.solve(rho, theta_rad, height_m, kHeight_m, 0.0, 0.0).valid);
    return line.task().jacobian();
  };
  const Eigen::MatrixXd current = jacobian_of(InteractionMatrix::current);
  Eigen::MatrixXd desired(3, 4);      // at ρ = θ = 0 and the height asked for
  desired << 0, 1 / kHeight_m, 0, 0,  //
      0, 0, 0, 1,                     //
      0, 0, 1 / kHeight_m, 0;
  EXPECT_LT((jacobian_of(InteractionMatrix::desired) - desired).norm(), 1e-12);
  EXPECT_LT((jacobian_of(InteractionMatrix::mean) - 0.5 * (current + desired)).norm(), 1e-12);
}

TEST(LineTask, BothSpellingsOfALineAcrossTheBranchAreTheSameLineOnTheFloor) {
  // (ρ, θ) and (−ρ, θ − π) are one line. Features tell θ in (−π/2, π/2], which is the branch of the goal
  // θ* = 0: a line a little to either side of vertical has a small θ, never one near ±π.
  for (const double heading_deg : {-89.0, -1.0, 0.0, 1.0, 89.0}) {
    const Pose pose{{0.0, 0.1}, radians(heading_deg), kHeight_m};
    const LineFeature forth = testing::seen_line(pose, kBehind_W, kAhead_W);
    const LineFeature back = testing::seen_line(pose, kAhead_W, kBehind_W);
    EXPECT_NEAR(forth.theta_rad, radians(heading_deg), 1e-12);
    EXPECT_NEAR(back.theta_rad, forth.theta_rad, 1e-12);
    EXPECT_NEAR(back.rho, forth.rho, 1e-12);
    EXPECT_NEAR(forth.rho, 0.1 / kHeight_m, 1e-12);  // to the right of the vehicle
  }
}

TEST(LineTask, AdaptiveGainGoesFromItsValueAtZeroToThatAtInfinity) {
  const AdaptiveGain gain{2.0, 0.5, 3.0};
  LineTask line(gain);
  const auto gain_at = [&](double offset) {
    return -line.solve(offset, 0.0, 1.0, 1.0, 0.0, 0.0).command.left_m_s / offset;
  };
  EXPECT_NEAR(gain_at(1e-7), gain.at_zero, 1e-6);
  EXPECT_NEAR(gain_at(50.0), gain.at_infinity, 1e-9);
  // λ(x) = (λ₀ − λ∞)·exp(−x·λ′₀ / (λ₀ − λ∞)) + λ∞
  EXPECT_NEAR(gain_at(0.2), 1.5 * std::exp(-0.2 * 3.0 / 1.5) + 0.5, 1e-9);
}

TEST(LineTask, AnImpossibleSceneIsNotValid) {
  LineTask line(kConstant);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(line.solve(kNaN, 0.0, 0.5, 0.5, 0.1, 0.0).valid);
  EXPECT_FALSE(line.solve(0.1, kNaN, 0.5, 0.5, 0.1, 0.0).valid);
  EXPECT_FALSE(line.solve(0.1, 0.0, kNaN, 0.5, 0.1, 0.0).valid);
  EXPECT_FALSE(line.solve(0.1, 0.0, 0.0, 0.5, 0.1, 0.0).valid);
  EXPECT_FALSE(line.solve(0.1, 0.0, 0.5, 0.5, kNaN, 0.0).valid);
  EXPECT_FALSE(line.solve(0.1, 0.0, 0.5, 0.5, 0.1, kNaN).valid);
  EXPECT_TRUE(line.solve(0.1, 0.0, 0.5, 0.5, 0.1, 0.0).valid);  // and it recovers
}

}  // namespace
}  // namespace lineservo::servo
