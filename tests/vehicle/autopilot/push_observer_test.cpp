#include "vehicle/autopilot/push_observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/attitude.h"
#include "vehicle/autopilot/attitude_controller.h"

namespace lineservo::vehicle {
namespace {

constexpr double kPeriod_s = 0.005;

const Gains& gains() {
  static const Gains kGains{AirframeParameters{}};
  return kGains;
}

/// Tilted, on the move, and pushed on top.
Estimate pushed(const Eigen::Vector2d& push_H_m_s2) {
  Estimate e;
  e.roll_rad = -0.05;
  e.pitch_rad = 0.08;
  e.v_H_m_s << 0.4, -0.2, 0.0;
  e.a_H_m_s2 =
      acceleration_of({e.roll_rad, e.pitch_rad}) - gains().drag_per_s * e.v_H_m_s.head<2>() + push_H_m_s2;
  return e;
}

TEST(PushObserver, TiltAndDragInStillAirAreNoPush) {
  PushObserver observer(gains(), kPeriod_s);
  for (int i = 0; i < 100; ++i) observer.update(pushed({0.0, 0.0}), 0.0);
  EXPECT_LT(observer.push_H_m_s2().norm(), 1e-12);
  EXPECT_LT(observer.led_push_H_m_s2().norm(), 1e-12);
}

// 1 − e^(−t/τ_d) and, led, 1 − e^(−t/τ_d) + (τ/τ_d) (t/τ_d) e^(−t/τ_d).
TEST(PushObserver, APushIsNoticedWithItsLagAndLedByThatOfTheTilt) {
  constexpr double kFine_s = 1e-5;
  PushObserver observer(gains(), kFine_s);
  const double lag_s = gains().push_lag_s;
  for (int i = 1; i <= 10000; ++i) {
    observer.update(pushed({1.0, -0.5}), 0.0);
    const double t = i * kFine_s / lag_s, rise = 1.0 - std::exp(-t);
    ASSERT_NEAR(observer.push_H_m_s2().x(), rise, 1e-9);
    ASSERT_NEAR(observer.led_push_H_m_s2().x(), rise + gains().attitude_lag_s / lag_s * t * std::exp(-t),
                5e-3);
    ASSERT_NEAR(observer.push_H_m_s2().y(), -0.5 * rise, 1e-9);
  }
}

TEST(PushObserver, TheAccelerationIsTheEstimatesInTheLongRun) {
  PushObserver observer(gains(), kPeriod_s);
  const Estimate e = pushed({0.3, 0.1});
  for (int i = 0; i < 200; ++i) observer.update(e, 0.0);
  EXPECT_LT((observer.acceleration_H_m_s2(e) - e.a_H_m_s2).norm(), 1e-9);
}

TEST(PushObserver, TheWindStaysWhereItIsWhileTheFrameTurns) {
  PushObserver observer(gains(), kPeriod_s);
  for (int i = 0; i < 200; ++i) observer.update(pushed({0.6, 0.0}), 0.0);
  constexpr double kStep_rad = 0.01;
  for (int i = 1; i <= 100; ++i) {
    const Eigen::Vector2d wind_H = turned({0.6, 0.0}, -i * kStep_rad);
    observer.update(pushed(wind_H), kStep_rad);
    ASSERT_LT((observer.push_H_m_s2() - wind_H).norm(), 1e-9);
    ASSERT_LT((observer.led_push_H_m_s2() - wind_H).norm(), 1e-9);
  }
}

TEST(PushObserver, WhatIsNoWindIsCutOffAndForgotten) {
  PushObserver observer(gains(), kPeriod_s);
  for (int i = 0; i < 200; ++i) observer.update(pushed({30.0, 40.0}), 0.0);
  EXPECT_NEAR(observer.push_H_m_s2().norm(), 3.0, 1e-12);
  EXPECT_NEAR(observer.push_H_m_s2().x(), 1.8, 1e-9);
  observer.forget();
  EXPECT_EQ(observer.push_H_m_s2(), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(observer.led_push_H_m_s2(), Eigen::Vector2d(0.0, 0.0));
}

}  // namespace
}  // namespace lineservo::vehicle
