#include "servo/executive/leg_compass.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace lineservo::servo {
namespace {

using features::LineFeature;
using features::radians;

constexpr Time kPeriod = std::chrono::milliseconds(100);

/// Lines at these angles (θ, degrees) as a vehicle of this heading sees them.
Observation seen(int frame, double yaw_rad, std::initializer_list<double> thetas_deg) {
  Observation o;
  o.now = o.captured = frame * kPeriod;
  o.estimate.odometry_at_capture.yaw_rad = yaw_rad;
  for (const double theta_deg : thetas_deg) {
    LineFeature line;
    line.theta_rad = radians(theta_deg);
    o.features.lines.push_back(line);
  }
  return o;
}

TEST(LegCompass, TheFirstLineIsFollowedWhileItGoesStraightOn) {
  LegCompass compass;
  for (int k = 0; k < 50; ++k) EXPECT_EQ(compass.straight_on(seen(k, 0.3, {2.0, -40.0})), 0u);
  EXPECT_EQ(compass.off_for_s(), 0.0);
}

TEST(LegCompass, OfTwoBranchesItNamesTheOneStraightOn) {
  LegCompass compass;
  compass.straight_on(seen(0, 0.0, {0.0}));
  EXPECT_EQ(compass.straight_on(seen(1, 0.0, {20.0, 1.0})), 1u);
  EXPECT_EQ(compass.straight_on(seen(2, 0.0, {-20.0, 30.0, -2.0})), 2u);
  EXPECT_EQ(compass.off_for_s(), 0.0);
}

// θ is the vehicle's heading less the line's: a vehicle that yaws sees the same line at another angle.
TEST(LegCompass, TheVehiclesOwnYawIsNoTurnOfTheLine) {
  LegCompass compass;
  for (int k = 0; k < 40; ++k) {
    const double yaw_rad = 1.0 + radians(k);
    EXPECT_EQ(compass.straight_on(seen(k, yaw_rad, {static_cast<double>(k)})), 0u);
  }
  EXPECT_EQ(compass.off_for_s(), 0.0);
}

TEST(LegCompass, ALineHasNoDirection) {
  LegCompass compass;
  compass.straight_on(seen(0, 0.0, {0.0}));
  EXPECT_EQ(compass.straight_on(seen(1, features::kPi, {0.0})), 0u);
  EXPECT_EQ(compass.off_for_s(), 0.0);
}

TEST(LegCompass, CountsForHowLongTheOnlyLineTurnsOff) {
  LegCompass compass;
  compass.straight_on(seen(0, 0.0, {0.0}));
  for (int k = 1; k <= 10; ++k) EXPECT_EQ(compass.straight_on(seen(k, 0.0, {25.0})), 0u);
  EXPECT_NEAR(compass.off_for_s(), 1.0, 1e-9);
  compass.straight_on(seen(11, 0.0, {1.0}));
  EXPECT_EQ(compass.off_for_s(), 0.0);
}

TEST(LegCompass, ARepeatedStampTakesNoTimeAndAnEmptyFrameTellsNothing) {
  LegCompass compass;
  EXPECT_EQ(compass.straight_on(seen(0, 0.0, {})), 0u);
  compass.straight_on(seen(1, 0.0, {0.0}));
  compass.straight_on(seen(2, 0.0, {25.0}));
  const double once_s = compass.off_for_s();
  EXPECT_NEAR(once_s, 0.1, 1e-9);
  compass.straight_on(seen(2, 0.0, {25.0}));
  EXPECT_EQ(compass.straight_on(seen(3, 0.0, {})), 0u);
  EXPECT_NEAR(compass.off_for_s(), once_s, 1e-9);
}

// Time that runs backwards must neither count nor push the heading away from the line.
TEST(LegCompass, AFrameOutOfOrderTakesNoTime) {
  LegCompass compass;
  compass.straight_on(seen(1000, 0.0, {0.0}));
  compass.straight_on(seen(0, 0.0, {-10.0}));
  EXPECT_EQ(compass.straight_on(seen(1001, 0.0, {-10.0})), 0u);
  EXPECT_EQ(compass.off_for_s(), 0.0);
  compass.straight_on(seen(1002, 0.0, {40.0}));
  compass.straight_on(seen(900, 0.0, {40.0}));
  EXPECT_GE(compass.off_for_s(), 0.0);
}

TEST(LegCompass, ALineThatIsNotFiniteIsNotNamed) {
  LegCompass compass;
  compass.straight_on(seen(0, 0.0, {0.0}));
  EXPECT_EQ(compass.straight_on(seen(1, 0.0, {25.0, std::nan(""), 0.5})), 2u);
}

// Of a gyro that drifts by r the heading lags behind by r τ, far less than what counts as off.
TEST(LegCompass, FollowsTheDriftOfTheGyro) {
  LegCompass compass;
  const double rate_deg_s = 0.2;
  for (int k = 0; k < 6000; ++k) {
    const double drift_deg = rate_deg_s * 0.1 * k;
    ASSERT_EQ(compass.straight_on(seen(k, radians(drift_deg), {0.0})), 0u);
    ASSERT_EQ(compass.off_for_s(), 0.0) << k;
  }
}

TEST(LegCompass, ARestartForgetsTheHeading) {
  LegCompass compass;
  compass.straight_on(seen(0, 0.0, {0.0}));
  compass.straight_on(seen(1, 0.0, {50.0}));
  compass.restart();
  EXPECT_EQ(compass.off_for_s(), 0.0);
  compass.straight_on(seen(2, 0.0, {50.0}));
  EXPECT_EQ(compass.straight_on(seen(3, 0.0, {49.0, 0.0})), 0u);
}

}  // namespace
}  // namespace lineservo::servo
