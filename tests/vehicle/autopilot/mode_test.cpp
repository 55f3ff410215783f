#include "vehicle/autopilot/mode.h"

#include <gtest/gtest.h>

namespace lineservo::vehicle {
namespace {

using enum AutopilotMode;

Situation with_command() {
  Situation s;
  s.command_live = true;
  return s;
}

TEST(Mode, OnTheGroundOnlyAClimbStartsTheMotors) {
  Situation s = with_command();
  EXPECT_EQ(next_mode(idle, s), idle);
  EXPECT_EQ(next_mode(landed, s), landed);
  s.wants_up = true;
  EXPECT_EQ(next_mode(idle, s), tracking);
  EXPECT_EQ(next_mode(landed, s), tracking);
  s.estimate_fresh = false;
  EXPECT_EQ(next_mode(idle, s), idle);
}

TEST(Mode, WithoutACommandWithoutAnEstimateOrBlindItBrakes) {
  EXPECT_EQ(next_mode(tracking, with_command()), tracking);
  EXPECT_EQ(next_mode(tracking, Situation{}), braking);
  Situation stale = with_command();
  stale.estimate_fresh = false;
  EXPECT_EQ(next_mode(tracking, stale), braking);
  Situation blind = with_command();
  blind.blind = true;
  EXPECT_EQ(next_mode(tracking, blind), braking);
}

TEST(Mode, BrakingEndsWithACommandOrAfterFiveSeconds) {
  EXPECT_EQ(next_mode(braking, with_command()), tracking);
  Situation s;
  s.in_mode_for = kBrakesFor - Time(1);
  EXPECT_EQ(next_mode(braking, s), braking);
  s.in_mode_for = kBrakesFor;
  EXPECT_EQ(next_mode(braking, s), landing);
}

TEST(Mode, ALongFlightIsNotMistakenForLongBraking) {
  Situation s;
  s.in_mode_for = 100 * kBrakesFor;
  EXPECT_EQ(next_mode(tracking, s), braking);
}

TEST(Mode, LandingGoesOnUntilTheGroundOrANewCommand) {
  Situation s;
  s.land_requested = true;
  EXPECT_EQ(next_mode(tracking, s), landing);
  EXPECT_EQ(next_mode(braking, s), landing);
  EXPECT_EQ(next_mode(landing, s), landing);
  EXPECT_EQ(next_mode(landing, with_command()), tracking);
  s.settled_on_ground = true;
  EXPECT_EQ(next_mode(landing, s), landed);
}

TEST(Mode, MotorsRunInTheAirOnly) {
  EXPECT_FALSE(motors_run(idle));
  EXPECT_FALSE(motors_run(landed));
  for (const AutopilotMode mode : {tracking, braking, landing}) EXPECT_TRUE(motors_run(mode));
}

}  // namespace
}  // namespace lineservo::vehicle
