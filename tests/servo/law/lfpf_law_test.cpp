#include "servo/law/lfpf_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/servo/law/follower_views.h"

namespace lineservo::servo {
namespace {

using features::degrees;
using features::JunctionCode;
using features::radians;
using testing::at_px;
using testing::attitude;
using testing::kFollowerGoal;
using testing::line_view;

/// A line straight ahead, so many pixels to the right of the centre.
Observation forward_line(double off_px) {
  return line_view(at_px(off_px, 240.0), at_px(off_px, -240.0));
}

// roll = 1.2° (0.5 − 1/(1 + e^{80/80})) = 1.2° · 0.231059 = 0.277270°, and the mirror image of it.
TEST(LfpfLaw, RollByHand) {
  LfpfLaw law({});
  EXPECT_NEAR(degrees(attitude(law, forward_line(80.0)).roll_rad), 0.277270, 1e-6);
  EXPECT_NEAR(degrees(attitude(law, forward_line(-80.0)).roll_rad), -0.277270, 1e-6);
  EXPECT_NEAR(attitude(law, forward_line(0.0)).roll_rad, 0.0, 1e-12);
}

TEST(LfpfLaw, RollNeverExceedsHalfOfC1) {
  LfpfLaw law({});
  EXPECT_NEAR(degrees(attitude(law, forward_line(1e6)).roll_rad), 0.6, 1e-9);
  EXPECT_NEAR(degrees(attitude(law, forward_line(-1e6)).roll_rad), -0.6, 1e-9);
}

// s is the midpoint of the line as it is in view: from (40, 240) to (120, −240) it lies at 80.
TEST(LfpfLaw, TheMidpointCounts) {
  LfpfLaw law({});
  EXPECT_NEAR(degrees(attitude(law, line_view(at_px(40.0, 240.0), at_px(120.0, -240.0))).roll_rad), 0.277270,
              1e-6);
}

// pitch = 0.01° sin 90° + 0.14° = 0.15° at the speed that it belongs to, in proportion at another: 0.19° at
// 0.09 m/s.
TEST(LfpfLaw, PitchByHand) {
  LfpfLaw law({.speed_hold_rad_per_m_s = 0.0});
  EXPECT_NEAR(degrees(attitude(law, forward_line(0.0), {0.071, 0.5}).pitch_rad), 0.15, 1e-9);
  EXPECT_NEAR(degrees(attitude(law, forward_line(0.0), {0.09, 0.5}).pitch_rad), 0.19, 0.001);
  const Observation slanted = line_view(at_px(-100.0, 100.0), at_px(100.0, -100.0));
  EXPECT_NEAR(degrees(attitude(law, slanted, {0.071, 0.5}).pitch_rad), 0.14 + 0.01 * std::sqrt(0.5), 1e-9);
}

TEST(LfpfLaw, HoldsTheSpeed) {
  LfpfLaw law({});
  Observation slow = forward_line(0.0), fast = forward_line(0.0);
  const double trim = attitude(law, forward_line(0.0)).pitch_rad;
  slow.estimate.v_H_m_s.x() = 0.05;
  fast.estimate.v_H_m_s.x() = 0.15;
  EXPECT_NEAR(attitude(law, slow).pitch_rad, trim + 0.1 * 0.05, 1e-12);
  EXPECT_NEAR(attitude(law, fast).pitch_rad, trim - 0.1 * 0.05, 1e-12);
}

// A line that leans to the right by 45° asks for a turn to the right, at 1/s.
TEST(LfpfLaw, TurnsOntoTheLine) {
  LfpfLaw law({});
  const double right = attitude(law, line_view(at_px(-100, 100), at_px(100, -100))).yaw_rate_rad_s;
  const double left = attitude(law, line_view(at_px(100, 100), at_px(-100, -100))).yaw_rate_rad_s;
  EXPECT_NEAR(right, -radians(45.0), 1e-9);
  EXPECT_NEAR(left, radians(45.0), 1e-9);
}

TEST(LfpfLaw, OverAJunctionItGoesByTheLineThatIsLedAlong) {
  LfpfLaw law({});
  Observation o = forward_line(80.0);
  o.features.lines = forward_line(-80.0).features.law.lines;
  EXPECT_GT(attitude(law, o).roll_rad, 0.0);
  o.features.code.smoothed = JunctionCode::cross;
  EXPECT_LT(attitude(law, o).roll_rad, 0.0);
  o.features.lines.clear();
  EXPECT_EQ(attitude(law, o).roll_rad, 0.0);
}

TEST(LfpfLaw, WithoutALineItGoesStraightOnOverAJunction) {
  LfpfLaw law({});
  const AttitudeCommand c = attitude(law, testing::empty_view(JunctionCode::start));
  EXPECT_NEAR(c.pitch_rad, attitude(law, forward_line(0.0)).pitch_rad, 1e-12);
  EXPECT_NEAR(c.roll_rad, 0.0, 1e-12);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
}

void expect_level(const AttitudeCommand& c) {
  EXPECT_EQ(c.roll_rad, 0.0);
  EXPECT_EQ(c.pitch_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(c.height_m, kFollowerGoal.height_m);
}

TEST(LfpfLaw, WithoutALineItKeepsLevel) {
  LfpfLaw law({});
  expect_level(attitude(law, testing::empty_view()));
  expect_level(attitude(law, line_view(at_px(-320.0, 10.0), at_px(320.0, 0.0))));  // across the way
  Observation broken = forward_line(0.0);
  broken.features.law.lines[0].begin.x = std::nan("");
  expect_level(attitude(law, broken));
}

TEST(LfpfLaw, WithoutAVelocityEstimateItKeepsThePublishedPitch) {
  LfpfLaw law({});
  Observation o = forward_line(0.0);
  const double trim = attitude(law, o).pitch_rad;
  o.estimate.v_H_m_s.x() = std::nan("");
  EXPECT_NEAR(attitude(law, o).pitch_rad, trim, 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
