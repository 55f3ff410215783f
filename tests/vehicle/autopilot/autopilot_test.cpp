#include "vehicle/autopilot/autopilot.h"

#include <gtest/gtest.h>

namespace lineservo::vehicle {
namespace {

using std::chrono::milliseconds;

VelocitySetpoint climbing() {
  VelocitySetpoint s;
  s.v_H_m_s.z() = 0.3;
  return s;
}

Estimate standing(Time t, double height_m = 0.10) {
  Estimate e;
  e.stamp = t;
  e.height_m = height_m;
  return e;
}

TEST(Autopilot, StandsStillUntilACommandToClimb) {
  Autopilot autopilot({}, {});
  EXPECT_EQ(autopilot.update(Time(0), standing(Time(0))), PerRotor::Zero());
  EXPECT_EQ(autopilot.mode(), AutopilotMode::idle);
  autopilot.command(VelocitySetpoint{}, milliseconds(5), kDefaultHold, milliseconds(5));
  EXPECT_EQ(autopilot.update(milliseconds(5), standing(milliseconds(5))), PerRotor::Zero());
  autopilot.command(climbing(), milliseconds(10), kDefaultHold, milliseconds(10));
  EXPECT_GT(autopilot.update(milliseconds(10), standing(milliseconds(10))).minCoeff(), 0.0);
  EXPECT_EQ(autopilot.mode(), AutopilotMode::tracking);
}

TEST(Autopilot, BrakesWhenItsEstimateIsOlderThanATenthOfASecond) {
  Autopilot autopilot({}, {});
  const Time hold = std::chrono::seconds(9);
  autopilot.command(climbing(), Time(0), hold, Time(0));
  const Estimate last = standing(milliseconds(5), 0.5);
  autopilot.update(milliseconds(5), last);
  autopilot.update(milliseconds(105), last);
  EXPECT_EQ(autopilot.mode(), AutopilotMode::tracking);
  autopilot.update(milliseconds(110), last);
  EXPECT_EQ(autopilot.mode(), AutopilotMode::braking);
}

TEST(Autopilot, RefusesBadParameters) {
  AirframeParameters heavy;
  heavy.mass_kg = 30.0;
  EXPECT_THROW(Autopilot(heavy, {}), std::invalid_argument);
  AutopilotOptions bad;
  bad.descent_speed_m_s = 0.0;
  EXPECT_THROW(Autopilot({}, bad), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
