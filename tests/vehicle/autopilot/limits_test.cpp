#include "vehicle/autopilot/limits.h"

#include <gtest/gtest.h>

#include "vehicle/autopilot/odometer.h"

namespace lineservo::vehicle {
namespace {

const SafetyLimits kLimits;

Estimate at_height(double height_m) {
  Estimate e;
  e.height_m = height_m;
  return e;
}

TEST(Limits, AVelocityKeepsItsDirectionAndLosesWhatIsTooMuch) {
  VelocitySetpoint wish;
  wish.v_H_m_s << 6.0, 8.0, 5.0;
  wish.yaw_rate_rad_s = -9.0;
  const VelocitySetpoint s = limited(wish, at_height(0.5), kLimits);
  EXPECT_NEAR((s.v_H_m_s - Eigen::Vector3d(1.2, 1.6, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(s.yaw_rate_rad_s, -2.0);
}

TEST(Limits, WhatIsAllowedPassesUntouched) {
  VelocitySetpoint wish;
  wish.v_H_m_s << 0.3, -0.2, -0.4;
  wish.yaw_rate_rad_s = 0.7;
  const VelocitySetpoint s = limited(wish, at_height(1.0), kLimits);
  EXPECT_EQ(s.v_H_m_s, wish.v_H_m_s);
  EXPECT_EQ(s.yaw_rate_rad_s, 0.7);
}

TEST(Limits, AboveTheGreatestHeightItDescends) {
  VelocitySetpoint up;
  up.v_H_m_s.z() = 0.5;
  EXPECT_NEAR(limited(up, at_height(3.0), kLimits).v_H_m_s.z(), 0.0, 1e-12);
  EXPECT_NEAR(limited(up, at_height(3.2), kLimits).v_H_m_s.z(), -0.2 * kHeightGain_per_s, 1e-12);
}

TEST(Limits, ATiltKeepsItsDirection) {
  AttitudeSetpoint wish;
  wish.roll_rad = 3.0;
  wish.pitch_rad = -4.0;
  wish.height_m = 10.0;
  const AttitudeSetpoint s = limited(wish, kLimits);
  EXPECT_NEAR(s.roll_rad, 0.6 * kLimits.max_tilt_rad, 1e-12);
  EXPECT_NEAR(s.pitch_rad, -0.8 * kLimits.max_tilt_rad, 1e-12);
  EXPECT_EQ(s.height_m, 3.0);
}

TEST(Limits, AtTheGreatestSpeedNoFurtherPushAlongIt) {
  Estimate fast;
  fast.v_H_m_s << 2.0, 0.0, 0.0;
  EXPECT_NEAR((speed_limited({3.0, 1.0}, fast, 2.0, kLimits) - Eigen::Vector2d(0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(speed_limited({-3.0, 1.0}, fast, 2.0, kLimits), Eigen::Vector2d(-3.0, 1.0));
  fast.v_H_m_s.x() = 2.5;
  EXPECT_NEAR(speed_limited({3.0, 0.0}, fast, 2.0, kLimits).x(), -1.0, 1e-12);
}

TEST(Odometer, CountsTheWaySincePaintAndSparesWhatCameAfterThePicture) {
  BlindOdometer odometer;
  Estimate e;
  e.v_H_m_s << 0.3, 0.4, 9.0;
  for (int i = 0; i < 200; ++i) odometer.travel(e, 0.005);
  EXPECT_NEAR(odometer.travelled_m(), 0.5, 1e-12);
  e.stamp = std::chrono::seconds(1);
  odometer.paint_sighted(std::chrono::milliseconds(900), e);
  EXPECT_NEAR(odometer.travelled_m(), 0.05, 1e-12);
  odometer.paint_sighted(std::chrono::milliseconds(800), e);  // an older picture says nothing new
  EXPECT_NEAR(odometer.travelled_m(), 0.05, 1e-12);
}

TEST(AutopilotOptionsTest, BadOnesAreRefused) {
  AutopilotOptions bad;
  bad.limits.max_tilt_rad = 2.0;
  EXPECT_THROW(bad.validate(), std::invalid_argument);
  bad = {};
  bad.limits.max_blind_travel_m = -1.0;
  EXPECT_THROW(bad.validate(), std::invalid_argument);
  EXPECT_NO_THROW(AutopilotOptions{}.validate());
}

}  // namespace
}  // namespace lineservo::vehicle
