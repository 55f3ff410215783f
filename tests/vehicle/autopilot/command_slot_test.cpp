#include "vehicle/autopilot/command_slot.h"

#include <gtest/gtest.h>

#include <limits>

namespace lineservo::vehicle {
namespace {

using std::chrono::milliseconds;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

VelocitySetpoint forward(double speed_m_s) {
  VelocitySetpoint s;
  s.v_H_m_s.x() = speed_m_s;
  return s;
}

TEST(CommandSlot, ACommandHoldsFromItsStampForItsTime) {
  CommandSlot slot;
  EXPECT_EQ(slot.live(Time(0)), nullptr);
  EXPECT_TRUE(slot.offer(forward(1.0), milliseconds(100), milliseconds(300), milliseconds(150)));
  EXPECT_NE(slot.live(milliseconds(400)), nullptr);
  EXPECT_EQ(slot.live(milliseconds(401)), nullptr);
}

TEST(CommandSlot, RefusesWhatIsNotFiniteAndKeepsWhatItHas) {
  CommandSlot slot;
  slot.offer(forward(1.0), Time(0), milliseconds(300), Time(0));
  EXPECT_FALSE(slot.offer(forward(kNaN), milliseconds(10), milliseconds(300), milliseconds(10)));
  AttitudeSetpoint tilt;
  tilt.height_m = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(slot.offer(tilt, milliseconds(10), milliseconds(300), milliseconds(10)));
  ASSERT_NE(slot.live(milliseconds(20)), nullptr);
  EXPECT_EQ(std::get<VelocitySetpoint>(*slot.live(milliseconds(20))).v_H_m_s.x(), 1.0);
  EXPECT_EQ(slot.live(milliseconds(301)), nullptr);  // the refused one did not prolong it
}

TEST(CommandSlot, RefusesTheOldTheFutureAndTheEmpty) {
  CommandSlot slot;
  EXPECT_TRUE(slot.offer(forward(1.0), milliseconds(50), milliseconds(300), milliseconds(50)));
  EXPECT_FALSE(slot.offer(forward(2.0), milliseconds(49), milliseconds(300), milliseconds(60)));
  EXPECT_FALSE(slot.offer(forward(2.0), milliseconds(61), milliseconds(300), milliseconds(60)));
  EXPECT_FALSE(slot.offer(forward(2.0), milliseconds(60), Time(0), milliseconds(60)));
}

TEST(CommandSlot, RefusesWhatHasRunOutAndKeepsWhatItHas) {
  CommandSlot slot;
  slot.offer(forward(1.0), Time(0), milliseconds(900), Time(0));
  EXPECT_FALSE(slot.offer(forward(2.0), milliseconds(100), milliseconds(300), milliseconds(401)));
  ASSERT_NE(slot.live(milliseconds(401)), nullptr);
  EXPECT_EQ(std::get<VelocitySetpoint>(*slot.live(milliseconds(401))).v_H_m_s.x(), 1.0);
}

TEST(CommandSlot, ACommandMayHoldForever) {
  CommandSlot slot;
  EXPECT_TRUE(slot.offer(forward(1.0), milliseconds(100), Time::max(), milliseconds(100)));
  EXPECT_NE(slot.live(std::chrono::hours(1000)), nullptr);
}

TEST(CommandSlot, ALateCommandToLandIsObeyed) {
  CommandSlot slot;
  EXPECT_TRUE(slot.offer(LandSetpoint{}, Time(0), milliseconds(300), milliseconds(500)));
  EXPECT_TRUE(slot.land_requested());
}

TEST(CommandSlot, LandingDoesNotRunOutAndIsNoCommandToFly) {
  CommandSlot slot;
  slot.offer(LandSetpoint{}, Time(0), milliseconds(300), Time(0));
  EXPECT_TRUE(slot.land_requested());
  EXPECT_EQ(slot.live(milliseconds(1)), nullptr);
  slot.offer(forward(0.1), milliseconds(500), milliseconds(300), milliseconds(500));
  EXPECT_FALSE(slot.land_requested());
}

}  // namespace
}  // namespace lineservo::vehicle
