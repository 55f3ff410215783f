#include "servo/law/improved_carrot_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/servo/law/follower_views.h"

namespace lineservo::servo {
namespace {

using features::degrees;
using testing::at_px;
using testing::attitude;
using testing::boundary_view;
using testing::kFollowerGoal;

constexpr FollowGoal kPublished{0.46, 0.5};

/// A line through the centre, so many degrees to the left of straight ahead: u is that angle.
Observation turned_line(double left_deg) {
  const double a = features::radians(left_deg);
  const double x = -200.0 * std::sin(a), y = -200.0 * std::cos(a);
  Observation o = boundary_view(at_px(-x, -y), at_px(x, y));
  o.estimate.v_H_m_s.x() = kPublished.speed_m_s;
  return o;
}

AttitudeCommand command(double left_deg, const FollowGoal& goal = kPublished) {
  ImprovedCarrotLaw law({.speed_hold_rad_per_m_s = 0.0});
  return attitude(law, turned_line(left_deg), goal);
}

// roll = 0.0013 · 1500 (e^{sin u} − 1): to the right by 10° 1.95° (e^{0.173648} − 1) = 0.369821°, to the left
// 1.95° (1 − e^{−0.173648}) = 0.310866°.
TEST(ImprovedCarrotLaw, RollByHand) {
  EXPECT_NEAR(degrees(command(-10.0).roll_rad), 1.95 * (std::exp(0.17364818) - 1.0), 1e-6);
  EXPECT_NEAR(degrees(command(10.0).roll_rad), -1.95 * (1.0 - std::exp(-0.17364818)), 1e-6);
  EXPECT_NEAR(command(0.0).roll_rad, 0.0, 1e-9);
}

// pitch = 1° − 0.016 · 1500 (1 − cos 10°) = 1° − 24° · 0.0151922 = 0.635386°, and no less than 0.
TEST(ImprovedCarrotLaw, PitchByHand) {
  EXPECT_NEAR(degrees(command(0.0).pitch_rad), 1.0, 1e-9);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(degrees(command(side * 10.0).pitch_rad), 0.635386, 1e-5);
    EXPECT_NEAR(command(side * 17.0).pitch_rad, 0.0, 1e-9);
    EXPECT_NEAR(command(side * 60.0).pitch_rad, 0.0, 1e-9);
  }
}

TEST(ImprovedCarrotLaw, RollAndPitchAreInProportionToTheSpeed) {
  const AttitudeCommand full = command(10.0), half = command(10.0, {0.23, 0.5});
  EXPECT_NEAR(half.roll_rad, 0.5 * full.roll_rad, 1e-12);
  EXPECT_NEAR(half.pitch_rad, 0.5 * full.pitch_rad, 1e-12);
  EXPECT_NEAR(half.yaw_rate_rad_s, full.yaw_rate_rad_s, 1e-12);
}

TEST(ImprovedCarrotLaw, TurnsAndRollsTowardsTheLine) {
  EXPECT_NEAR(command(10.0).yaw_rate_rad_s, 3.0 * features::radians(10.0), 1e-9);
  EXPECT_LT(command(10.0).roll_rad, 0.0);  // left side down
  EXPECT_LT(command(-10.0).yaw_rate_rad_s, 0.0);
  EXPECT_GT(command(-10.0).roll_rad, 0.0);
}

// It holds the lower speed that the turn asks for.
TEST(ImprovedCarrotLaw, HoldsTheSpeedOfTheTurn) {
  ImprovedCarrotLaw law({});
  Observation o = turned_line(10.0);
  o.estimate.v_H_m_s.x() = 0.635386 * 0.46;
  EXPECT_NEAR(degrees(attitude(law, o, kPublished).pitch_rad), 0.635386, 1e-4);
  o.estimate.v_H_m_s.x() += 0.1;
  EXPECT_NEAR(attitude(law, o, kPublished).pitch_rad, features::radians(0.635386) - 0.01, 1e-5);
}

TEST(ImprovedCarrotLaw, WithoutWayPointsItKeepsLevel) {
  ImprovedCarrotLaw law({});
  const AttitudeCommand c = attitude(law, testing::empty_view());
  EXPECT_EQ(c.roll_rad, 0.0);
  EXPECT_EQ(c.pitch_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(c.height_m, kFollowerGoal.height_m);
}

TEST(ImprovedCarrotLaw, WithoutALineItGoesStraightOnOverAJunction) {
  ImprovedCarrotLaw law({});
  const AttitudeCommand c = attitude(law, testing::empty_view(features::JunctionCode::start));
  EXPECT_GT(c.pitch_rad, 0.0);
  EXPECT_EQ(c.roll_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
}

}  // namespace
}  // namespace lineservo::servo
