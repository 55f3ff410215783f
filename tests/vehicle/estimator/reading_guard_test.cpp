#include "vehicle/estimator/reading_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lineservo::vehicle {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// At rest but for the accelerometer's noise, which never repeats.
SensorReadings reading(int k) {
  SensorReadings r;
  r.stamp = k * std::chrono::milliseconds(5);
  r.gyro_B_rad_s << 0.01, -0.02, 0.1;
  r.specific_force_B_m_s2 << 0.05 * k, 0.0, 9.81;
  r.roll_rad = 0.01;
  r.pitch_rad = -0.02;
  r.flow_v_H_m_s = Eigen::Vector2d(0.1, 0.0);
  r.range_m = 0.5 + 0.001 * k;
  return r;
}

SensorReadings passed(ReadingGuard& guard, const SensorReadings& r) {
  return guard.checked(r, 0.03, 0.04);
}

TEST(ReadingGuard, LetsWhatIsSoundThroughAsItIs) {
  ReadingGuard guard(reading(0));
  for (int k = 1; k < 50; ++k) {
    const SensorReadings in = reading(k), out = passed(guard, in);
    EXPECT_EQ(out.stamp, in.stamp);
    EXPECT_EQ(out.gyro_B_rad_s, in.gyro_B_rad_s);
    EXPECT_EQ(out.specific_force_B_m_s2, in.specific_force_B_m_s2);
    EXPECT_EQ(out.roll_rad, in.roll_rad);
    EXPECT_EQ(out.pitch_rad, in.pitch_rad);
    EXPECT_EQ(out.flow_v_H_m_s, in.flow_v_H_m_s);
    EXPECT_EQ(out.range_m, in.range_m);
  }
}

TEST(ReadingGuard, TheLastGoodInertialReadingStandsInForABadOne) {
  for (const double bad : {kNaN, kInf, -kInf, 1e6}) {
    ReadingGuard guard(reading(0));
    passed(guard, reading(1));
    SensorReadings r = reading(2);
    r.gyro_B_rad_s.y() = bad;
    r.specific_force_B_m_s2.z() = bad;
    const SensorReadings out = passed(guard, r);
    EXPECT_EQ(out.gyro_B_rad_s, reading(1).gyro_B_rad_s);
    EXPECT_EQ(out.specific_force_B_m_s2, reading(1).specific_force_B_m_s2);
  }
}

TEST(ReadingGuard, ABadFlowOrRangeDidNotCome) {
  for (const double bad : {kNaN, kInf, -kInf, 1e3, -1e3}) {
    ReadingGuard guard(reading(0));
    SensorReadings r = reading(1);
    r.flow_v_H_m_s->x() = bad;
    r.range_m = bad;
    const SensorReadings out = passed(guard, r);
    EXPECT_FALSE(out.flow_v_H_m_s.has_value()) << bad;
    EXPECT_FALSE(out.range_m.has_value()) << bad;
  }
}

TEST(ReadingGuard, AGivenAttitudeStandsInForOneThatDoesNotCome) {
  ReadingGuard guard(reading(0));
  SensorReadings r = reading(1);
  r.pitch_rad = kNaN;
  const SensorReadings out = passed(guard, r);
  EXPECT_EQ(out.roll_rad, 0.03);
  EXPECT_EQ(out.pitch_rad, 0.04);
}

TEST(ReadingGuard, ASingleJumpOfTheGyroIsAnOutlier) {
  ReadingGuard guard(reading(0));
  SensorReadings wild = reading(1);
  wild.gyro_B_rad_s.x() += 10.0;
  EXPECT_EQ(passed(guard, wild).gyro_B_rad_s, reading(0).gyro_B_rad_s);
  EXPECT_EQ(passed(guard, reading(2)).gyro_B_rad_s, reading(2).gyro_B_rad_s);
}

// So that a body that really does spin up is not flown by what it did before.
TEST(ReadingGuard, AJumpThatStaysIsBelieved) {
  ReadingGuard guard(reading(0));
  int refused = 0;
  for (int k = 1; k < 20; ++k) {
    SensorReadings r = reading(k);
    r.gyro_B_rad_s.x() += 10.0;
    refused += passed(guard, r).gyro_B_rad_s != r.gyro_B_rad_s ? 1 : 0;
  }
  EXPECT_EQ(refused, 4);
}

// One in ten of the readings wild: five in a row come within minutes.
TEST(ReadingGuard, ManyWildReadingsInARowAreNotBelieved) {
  ReadingGuard guard(reading(0));
  int k = 1;
  for (; k < 20; ++k) {
    SensorReadings wild = reading(k);
    wild.gyro_B_rad_s.x() += k % 2 == 0 ? 15.0 : -15.0;
    ASSERT_EQ(passed(guard, wild).gyro_B_rad_s, reading(0).gyro_B_rad_s) << k;
  }
  for (; k < 30; ++k) ASSERT_EQ(passed(guard, reading(k)).gyro_B_rad_s, reading(k).gyro_B_rad_s) << k;
}

TEST(ReadingGuard, ARangeThatRepeatsWhileTheBodyMovesIsFrozen) {
  ReadingGuard guard(reading(0));
  int passed_on = 0;
  for (int k = 1; k <= 40; ++k) {
    SensorReadings r = reading(k);
    r.range_m = 0.7;
    passed_on += passed(guard, r).range_m.has_value() ? 1 : 0;
  }
  EXPECT_EQ(passed_on, 10);  // 0.2 s at 50 Hz
  EXPECT_TRUE(passed(guard, reading(41)).range_m.has_value()) << "alive again";
}

TEST(ReadingGuard, OnTheGroundARangeMayRepeat) {
  const SensorReadings still = reading(0);
  ReadingGuard guard(still);
  for (int k = 1; k < 100; ++k) ASSERT_TRUE(passed(guard, still).range_m.has_value()) << k;
}

// Without noise, the force alone changes, by what the legs give way.
TEST(ReadingGuard, SettlingOnTheGroundIsNoMotion) {
  SensorReadings still = reading(0);
  ReadingGuard guard(still);
  for (int k = 1; k < 100; ++k) {
    still.specific_force_B_m_s2.z() += k % 2 == 0 ? 1e-3 : -1e-3;
    ASSERT_TRUE(passed(guard, still).range_m.has_value()) << k;
  }
}

TEST(ReadingGuard, WhatDoesNotComeIsNotARepetition) {
  ReadingGuard guard(reading(0));
  for (int k = 1; k < 100; ++k) {
    SensorReadings r = reading(k);
    if (k % 4 != 0) r.range_m.reset();
    EXPECT_EQ(passed(guard, r).range_m, r.range_m) << k;
  }
}

// Nothing good came before: rest on the ground stands in.
TEST(ReadingGuard, WhatComesThroughIsFiniteFromTheFirstOn) {
  SensorReadings first = reading(0);
  first.gyro_B_rad_s.setConstant(kNaN);
  first.specific_force_B_m_s2.setConstant(kNaN);
  ReadingGuard guard(first);
  const SensorReadings out = passed(guard, first);
  EXPECT_TRUE(out.gyro_B_rad_s.allFinite());
  EXPECT_TRUE(out.specific_force_B_m_s2.allFinite());
  EXPECT_EQ(passed(guard, reading(1)).gyro_B_rad_s, reading(1).gyro_B_rad_s);
}

}  // namespace
}  // namespace lineservo::vehicle
