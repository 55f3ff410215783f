#include "servo/law/limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lineservo::servo {
namespace {

const CommandLimits kLimits{1.5, 0.5, 1.2, 2.0, 4.0};

TEST(Saturate, LeavesWhatIsWithinTheLimits) {
  const VelocityCommand c = saturate({0.9, -1.2, 0.5, -1.2}, kLimits);  // 0.9² + 1.2² = 1.5²
  EXPECT_DOUBLE_EQ(c.forward_m_s, 0.9);
  EXPECT_DOUBLE_EQ(c.left_m_s, -1.2);
  EXPECT_DOUBLE_EQ(c.up_m_s, 0.5);
  EXPECT_DOUBLE_EQ(c.yaw_rate_rad_s, -1.2);
}

TEST(Saturate, KeepsTheHorizontalDirection) {
  for (const auto& [forward, left] : {std::pair{3.0, 4.0}, {-3.0, 4.0}, {0.0, -9.0}, {100.0, 1.0}}) {
    const VelocityCommand c = saturate({forward, left, 0.0, 0.0}, kLimits);
    EXPECT_NEAR(std::hypot(c.forward_m_s, c.left_m_s), 1.5, 1e-12);
    EXPECT_NEAR(std::atan2(c.left_m_s, c.forward_m_s), std::atan2(left, forward), 1e-12);
  }
}

TEST(Saturate, ClampsClimbAndYawOnBothSides) {
  const VelocityCommand up = saturate({0.0, 0.0, 2.0, 9.0}, kLimits);
  EXPECT_EQ(up.up_m_s, 0.5);
  EXPECT_EQ(up.yaw_rate_rad_s, 1.2);
  const VelocityCommand down = saturate({0.0, 0.0, -2.0, -9.0}, kLimits);
  EXPECT_EQ(down.up_m_s, -0.5);
  EXPECT_EQ(down.yaw_rate_rad_s, -1.2);
}

TEST(Approach, OneStepByHand) {
  // 2 m/s² · 0.1 s = 0.2 m/s towards (0.6, 0.8), so (0.12, 0.16); 4 rad/s² · 0.1 s = 0.4 rad/s.
  const VelocityCommand c = approach({}, {0.6, 0.8, -0.5, 1.0}, kLimits, 0.1);
  EXPECT_NEAR(c.forward_m_s, 0.12, 1e-12);
  EXPECT_NEAR(c.left_m_s, 0.16, 1e-12);
  EXPECT_NEAR(c.up_m_s, -0.2, 1e-12);
  EXPECT_NEAR(c.yaw_rate_rad_s, 0.4, 1e-12);
}

TEST(Approach, ReachesANearGoalInOneStepExactly) {
  const VelocityCommand c = approach({0.5, 0.1, 0.1, 0.2}, {0.6, 0.0, 0.2, 0.0}, kLimits, 0.1);
  EXPECT_DOUBLE_EQ(c.forward_m_s, 0.6);
  EXPECT_DOUBLE_EQ(c.left_m_s, 0.0);
  EXPECT_DOUBLE_EQ(c.up_m_s, 0.2);
  EXPECT_DOUBLE_EQ(c.yaw_rate_rad_s, 0.0);
}

TEST(Approach, BoundsEveryChangeAndArrives) {
  const VelocityCommand goal{-1.0, 0.7, 0.4, -1.2};
  VelocityCommand c{1.0, 0.0, -0.4, 1.2};
  constexpr double kDt_s = 1.0 / 30.0;
  for (int k = 0; k < 40; ++k) {
    const VelocityCommand before = c;
    c = approach(before, goal, kLimits, kDt_s);
    EXPECT_LE(std::hypot(c.forward_m_s - before.forward_m_s, c.left_m_s - before.left_m_s),
              2.0 * kDt_s + 1e-12);
    EXPECT_LE(std::abs(c.up_m_s - before.up_m_s), 2.0 * kDt_s + 1e-12);
    EXPECT_LE(std::abs(c.yaw_rate_rad_s - before.yaw_rate_rad_s), 4.0 * kDt_s + 1e-12);
  }
  EXPECT_NEAR(c.forward_m_s, goal.forward_m_s, 1e-12);
  EXPECT_NEAR(c.left_m_s, goal.left_m_s, 1e-12);
  EXPECT_NEAR(c.up_m_s, goal.up_m_s, 1e-12);
  EXPECT_NEAR(c.yaw_rate_rad_s, goal.yaw_rate_rad_s, 1e-12);
}

TEST(Approach, InNoTimeNothingChanges) {
  const VelocityCommand c = approach({0.1, 0.2, 0.3, 0.4}, {1.0, 1.0, 1.0, 1.0}, kLimits, 0.0);
  EXPECT_EQ(c.forward_m_s, 0.1);
  EXPECT_EQ(c.left_m_s, 0.2);
  EXPECT_EQ(c.up_m_s, 0.3);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.4);
  const VelocityCommand same = approach({0.1, 0.2, 0.3, 0.4}, {0.1, 0.2, 0.3, 0.4}, kLimits, 0.0);
  EXPECT_EQ(same.forward_m_s, 0.1);  // no change wanted and none allowed: not 0/0
}

}  // namespace
}  // namespace lineservo::servo
