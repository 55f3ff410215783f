#pragma once

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <functional>
#include <vector>

#include "servo/task/visual_task.h"
#include "tests/servo/test_pose.h"

namespace lineservo::servo::testing {

/// A visual task bound to a scene: `solve` gives it the exact features of a pose, without drift.
struct TaskUnderTest {
  const VisualTask& task;
  int dimension;
  Pose goal;
  double gain;  ///< constant λ
  /// `secondary`: the one motion that the task leaves free (forward speed, yaw rate).
  std::function<TaskSolution(const Pose&, double secondary)> solve;
  bool commands_yaw = true;  ///< otherwise J has nothing in the column of the yaw
};

inline Eigen::Vector4d vector_of(const VelocityCommand& c) {
  return {c.forward_m_s, c.left_m_s, c.up_m_s, c.yaw_rate_rad_s};
}

inline Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& J) {
  return J.completeOrthogonalDecomposition().pseudoInverse();
}

inline void expect_dimension(const TaskUnderTest& t, const Pose& pose) {
  const TaskSolution solution = t.solve(pose, 0.0);
  EXPECT_TRUE(solution.valid);
  EXPECT_EQ(static_cast<int>(solution.rank), t.dimension);
  EXPECT_EQ(t.task.error().size(), t.dimension);
  EXPECT_EQ(t.task.jacobian().rows(), t.dimension);
  EXPECT_EQ(t.task.jacobian().cols(), 4);
}

/// Column k of J is (e(+ε) − e(−ε)) / 2ε for a motion of the vehicle along its degree of freedom k.
inline void expect_jacobian_is_the_motion_of_the_error(const TaskUnderTest& t, const Pose& pose) {
  constexpr double kStep_s = 1e-5;
  t.solve(pose, 0.0);
  const Eigen::MatrixXd J = t.task.jacobian();
  const std::vector<VelocityCommand> motions = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  EXPECT_TRUE(t.commands_yaw || J.col(3).isZero(0.0));
  for (int k = 0; k < (t.commands_yaw ? 4 : 3); ++k) {
    t.solve(moved(pose, motions[static_cast<std::size_t>(k)], kStep_s), 0.0);
    const Eigen::VectorXd after = t.task.error();
    t.solve(moved(pose, motions[static_cast<std::size_t>(k)], -kStep_s), 0.0);
    const Eigen::VectorXd rate = (after - t.task.error()) / (2.0 * kStep_s);
    EXPECT_LT((J.col(k) - rate).cwiseAbs().maxCoeff(), 1e-7) << "degree of freedom " << k << "\n" << J;
  }
}

inline void expect_rest_at_goal(const TaskUnderTest& t) {
  const TaskSolution solution = t.solve(t.goal, 0.0);
  EXPECT_TRUE(solution.valid);
  EXPECT_LT(t.task.error().norm(), 1e-12);
  EXPECT_LT(vector_of(solution.command).norm(), 1e-12);
}

/// q̇ = −λ J⁺ e, with a J⁺ for which J J⁺ J = J: the shortest motion that lets e fall as ė = −λ e.
inline void expect_exponential_decrease(const TaskUnderTest& t, const Pose& pose) {
  const Eigen::Vector4d q = vector_of(t.solve(pose, 0.0).command);
  const Eigen::MatrixXd J = t.task.jacobian(), J_plus = pseudo_inverse(J);
  EXPECT_LT((J * J_plus * J - J).norm(), 1e-12);
  EXPECT_LT((J * q + t.gain * t.task.error()).norm(), 1e-10);
  EXPECT_LT((q + t.gain * J_plus * t.task.error()).norm(), 1e-10);
}

/// What the secondary motion adds lies in the null space: J·q̇₂ = 0.
inline void expect_secondary_leaves_the_error_alone(const TaskUnderTest& t, const Pose& pose,
                                                    double secondary) {
  const Eigen::Vector4d primary = vector_of(t.solve(pose, 0.0).command);
  const Eigen::Vector4d both = vector_of(t.solve(pose, secondary).command);
  EXPECT_LT((t.task.jacobian() * (both - primary)).norm(), 1e-12);
}

/// The bundle: what every visual task has to hold, at the goal and on a list of poses.
inline void expect_task_properties(const TaskUnderTest& t, const std::vector<Pose>& poses) {
  expect_rest_at_goal(t);
  for (const Pose& pose : poses) {
    SCOPED_TRACE(::testing::Message() << "at " << pose.p_W.transpose() << " m, heading " << pose.heading_rad
                                      << ", height " << pose.height_m);
    expect_dimension(t, pose);
    expect_jacobian_is_the_motion_of_the_error(t, pose);
    expect_exponential_decrease(t, pose);
    expect_secondary_leaves_the_error_alone(t, pose, 0.3);
  }
}

/// Poses about the origin: left and right of it, turned both ways, high and low.
inline std::vector<Pose> poses_around_origin() {
  std::vector<Pose> poses;
  for (const double left_m : {-0.2, 0.0, 0.15}) {
    for (const double heading_deg : {-25.0, 0.0, 40.0}) {
      for (const double height_m : {0.35, 0.8}) {
        poses.push_back({{0.1, left_m}, features::radians(heading_deg), height_m});
      }
    }
  }
  return poses;
}

}  // namespace lineservo::servo::testing
