#include "vehicle/autopilot/velocity_controller.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/autopilot/attitude_controller.h"

namespace lineservo::vehicle {
namespace {

constexpr double kPeriod_s = 0.005;

TEST(Gains, EachLoopIsSlowerThanTheOneInside) {
  const Gains g{AirframeParameters{}};
  EXPECT_GT(1.0 / g.rotor_lag_s, 2.0 * g.rate_per_s);
  EXPECT_GT(g.rate_per_s, 2.0 * g.attitude_per_s);
  EXPECT_GT(g.attitude_per_s, 2.0 * g.velocity_per_s);
}

TEST(Gains, DoNotDependOnTheVehiclesSizeOnlyOnItsLags) {
  AirframeParameters small;
  small.mass_kg = 0.063;
  small.inertia_kg_m2 << 5.829e-5, 7.169e-5, 1e-4;
  EXPECT_EQ(Gains(small).rate_per_s, Gains(AirframeParameters{}).rate_per_s);
  small.motor_lag_up_s = small.motor_lag_down_s = 0.020;
  EXPECT_NEAR(Gains(small).rate_per_s, 0.4 / 0.025, 1e-12);
}

TEST(ReferenceAxis, AnswersAsTheDampedSecondOrderSystemThatWasAsked) {
  ReferenceAxis axis({0.1, 5.0, 1.0, 100.0}, 1e-4);
  for (int i = 1; i <= 10000; ++i) {
    axis.step(1.0);
    const double wt = 5.0 * i * 1e-4;
    // Critically damped: 1 − (1 + ωt) e^(−ωt)
    EXPECT_NEAR(axis.velocity_m_s(), 1.0 - (1.0 + wt) * std::exp(-wt), 2e-3);
  }
}

TEST(ReferenceAxis, NeverAsksForMoreThanItsLimit) {
  ReferenceAxis axis({0.1, 8.0, 0.85, 2.0}, kPeriod_s);
  double before = 0.0;
  for (int i = 0; i < 600; ++i) {
    EXPECT_LE(std::abs(axis.step(3.0)), 2.0);
    EXPECT_LE(std::abs(axis.velocity_m_s() - before), 2.0 * kPeriod_s * (1 + 1e-9));
    before = axis.velocity_m_s();
  }
  EXPECT_NEAR(before, 3.0, 1e-2);
}

/// What the estimates say of a vehicle that is tilted for this acceleration and pushed on top.
void tilt_and_push(Estimate& e, const Eigen::Vector2d& tilt_m_s2, const Eigen::Vector2d& push_m_s2) {
  const TiltTarget tilt = tilt_for({tilt_m_s2.x(), tilt_m_s2.y(), kGravity_m_s2});
  e.roll_rad = tilt.roll_rad;
  e.pitch_rad = tilt.pitch_rad;
  e.a_H_m_s2 = tilt_m_s2 + push_m_s2;
}

TEST(HorizontalController, MakesUpForASteadyPush) {
  const Gains gains{AirframeParameters{}};
  HorizontalController controller(gains, {}, kPeriod_s);
  Estimate e;
  for (int i = 0; i < 4000; ++i) {
    tilt_and_push(e, controller.acceleration_H({0, 0}, e, 0.0), {0.7, -0.4});
    e.v_H_m_s.head<2>() += kPeriod_s * e.a_H_m_s2;
  }
  EXPECT_LT(e.v_H_m_s.norm(), 1e-6);
}

TEST(HorizontalController, SaturatedItDoesNotWindUp) {
  const Gains gains{AirframeParameters{}};
  HorizontalController controller(gains, {}, kPeriod_s);
  Estimate held;  // it leans into it and cannot move
  held.v_H_m_s.x() = -5.0;
  const double greatest_m_s2 = kGravity_m_s2 * std::tan(SafetyLimits{}.max_tilt_rad);
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector2d wanted = controller.acceleration_H({0, 0}, held, 0.0);
    EXPECT_LE(wanted.norm(), greatest_m_s2 + 1e-9);
    tilt_and_push(held, wanted, -wanted);
  }
  Estimate free;
  for (int i = 0; i < 40; ++i) controller.acceleration_H({0, 0}, free, 0.0);
  EXPECT_LT(controller.acceleration_H({0, 0}, free, 0.0).norm(), 0.01);
}

TEST(Attitude, TiltForAnAccelerationAndBack) {
  const Eigen::Vector2d a(1.5, -0.8);
  EXPECT_NEAR((acceleration_of(tilt_for({a.x(), a.y(), 9.81})) - a).norm(), 0.0, 1e-12);
  EXPECT_GT(tilt_for({1.0, 0.0, 9.81}).pitch_rad, 0.0);
  EXPECT_LT(tilt_for({0.0, 1.0, 9.81}).roll_rad, 0.0);
}

TEST(Attitude, BodyRatesTurnTowardsTheTargetAndCarryTheYawRate) {
  Estimate e;
  const Eigen::Vector3d w = body_rates_for({0.01, -0.02}, 0.0, e, 10.0);
  EXPECT_NEAR((w - Eigen::Vector3d(0.1, -0.2, 0.0)).norm(), 0.0, 2e-3);
  e.pitch_rad = 0.3;
  const Eigen::Vector3d level = body_rates_for({0.0, 0.3}, 1.0, e, 10.0);
  EXPECT_NEAR((level - Eigen::Vector3d(-std::sin(0.3), 0.0, std::cos(0.3))).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace lineservo::vehicle
