#include "servo/law/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

using std::chrono::milliseconds;

TEST(Odometry, BeforeAnyEstimateItIsAtTheOrigin) {
  const Motion pose = Odometry().at(milliseconds(100));
  EXPECT_EQ(pose.translation_m, Eigen::Vector2d::Zero());
  EXPECT_EQ(pose.yaw_rad, 0.0);
}

TEST(Odometry, StraightLineInTheHeading) {
  Odometry odometry;
  const double yaw_rad = 0.4;
  for (int k = 0; k <= 50; ++k) odometry.add(milliseconds(20 * k), {0.5, -0.2}, yaw_rad);
  const Eigen::Vector2d expected = Eigen::Rotation2Dd(yaw_rad) * Eigen::Vector2d(0.5, -0.2);
  const Motion pose = odometry.at(milliseconds(1000));
  EXPECT_LT((pose.translation_m - expected).norm(), 1e-12);
  EXPECT_EQ(pose.yaw_rad, yaw_rad);
}

TEST(Odometry, CircleOfRadiusSpeedOverYawRate) {
  // v = 0.6 m/s, ω = 0.5 rad/s: after a half turn 2·v/ω to the left. The mid-point rule is off by (ω·dt)²/24.
  Odometry odometry;
  const double speed_m_s = 0.6, yaw_rate_rad_s = 0.5, radius_m = speed_m_s / yaw_rate_rad_s;
  const int steps = 1000;
  const double duration_s = features::kPi / yaw_rate_rad_s;
  for (int k = 0; k <= steps; ++k) {
    const double t_s = duration_s * k / steps;
    odometry.add(std::chrono::nanoseconds(std::llround(t_s * 1e9)), {speed_m_s, 0.0}, yaw_rate_rad_s * t_s);
  }
  const Motion pose = odometry.at(std::chrono::seconds(10));
  EXPECT_LT((pose.translation_m - Eigen::Vector2d(0.0, 2.0 * radius_m)).norm(), 1e-5);
  EXPECT_NEAR(pose.yaw_rad, features::kPi, 1e-8);
}

TEST(Odometry, InterpolatesBetweenEstimates) {
  Odometry odometry;
  odometry.add(milliseconds(0), {1.0, 0.0}, 0.0);
  odometry.add(milliseconds(100), {1.0, 0.0}, 0.0);
  odometry.add(milliseconds(200), {0.0, 2.0}, 0.0);
  EXPECT_NEAR(odometry.at(milliseconds(25)).translation_m.x(), 0.025, 1e-12);
  EXPECT_NEAR(odometry.at(milliseconds(100)).translation_m.x(), 0.1, 1e-12);
  EXPECT_NEAR(odometry.at(milliseconds(150)).translation_m.x(), 0.1, 1e-12);
  EXPECT_NEAR(odometry.at(milliseconds(150)).translation_m.y(), 0.1, 1e-12);
}

TEST(Odometry, YawIsInterpolatedToo) {
  Odometry odometry;
  odometry.add(milliseconds(0), {0.0, 0.0}, 1.0);
  odometry.add(milliseconds(100), {0.0, 0.0}, 2.0);
  EXPECT_NEAR(odometry.at(milliseconds(30)).yaw_rad, 1.3, 1e-12);
}

TEST(Odometry, OutsideItsMemoryItTellsTheNearestEnd) {
  Odometry odometry;
  for (int k = 0; k <= 30; ++k) odometry.add(milliseconds(100 * k), {1.0, 0.0}, 0.0);
  EXPECT_NEAR(odometry.at(milliseconds(9000)).translation_m.x(), 3.0, 1e-12);  // the newest
  EXPECT_NEAR(odometry.at(milliseconds(2000)).translation_m.x(), 2.0, 1e-12);  // a second ago: remembered
  EXPECT_NEAR(odometry.at(milliseconds(500)).translation_m.x(), 2.0, 1e-12);   // before: the oldest
}

TEST(Odometry, AStampThatDoesNotGoOnIsIgnored) {
  Odometry odometry;
  odometry.add(milliseconds(0), {1.0, 0.0}, 0.0);
  odometry.add(milliseconds(100), {1.0, 0.0}, 0.0);
  odometry.add(milliseconds(50), {9.0, 9.0}, 3.0);
  odometry.add(milliseconds(100), {9.0, 9.0}, 3.0);
  EXPECT_NEAR(odometry.at(milliseconds(100)).translation_m.x(), 0.1, 1e-12);
  EXPECT_EQ(odometry.at(milliseconds(100)).yaw_rad, 0.0);
  odometry.add(milliseconds(200), {1.0, 0.0}, 0.0);
  EXPECT_NEAR(odometry.at(milliseconds(200)).translation_m.x(), 0.2, 1e-12);
  EXPECT_EQ(odometry.at(milliseconds(200)).translation_m.y(), 0.0);
}

}  // namespace
}  // namespace lineservo::servo
