#include "servo/law/drift_observer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lineservo::servo {
namespace {

constexpr double kTimeConstant_s = 1.5;
constexpr double kLimit_m_s = 0.3;

/// A vehicle that goes at 0.2 m/s by its odometry and at 0.2 m/s + drift in truth, measured without noise.
struct DriftingVehicle {
  DriftObserver observer{kTimeConstant_s, kLimit_m_s};
  double dt_s = 0.1;
  double position_m = 0.4;

  void start() { observer.update(position_m, 0.0, 0.0); }
  void fly(double drift_m_s, int steps) {
    for (int k = 0; k < steps; ++k) {
      const double odometry_step_m = 0.2 * dt_s;
      position_m += odometry_step_m + drift_m_s * dt_s;
      observer.update(position_m, odometry_step_m, dt_s);
    }
  }
};

TEST(DriftObserver, TheFirstMeasurementSaysNothing) {
  DriftObserver observer(kTimeConstant_s, kLimit_m_s);
  observer.update(5.0, 0.0, 0.1);
  EXPECT_EQ(observer.drift_m_s(), 0.0);
}

TEST(DriftObserver, WithoutDriftItStaysAtZero) {
  DriftingVehicle vehicle;
  vehicle.start();
  vehicle.fly(0.0, 100);
  EXPECT_NEAR(vehicle.observer.drift_m_s(), 0.0, 1e-12);
}

TEST(DriftObserver, OneStepByHand) {
  // r = (d·dt), d̂ = (1 − p)²·r / dt = (1 − p)²·d
  DriftingVehicle vehicle;
  vehicle.start();
  vehicle.fly(0.06, 1);
  const double p = std::exp(-0.1 / kTimeConstant_s);
  EXPECT_NEAR(vehicle.observer.drift_m_s(), (1.0 - p) * (1.0 - p) * 0.06, 1e-15);
}

TEST(DriftObserver, ConvergesToAConstantDriftOfEitherSign) {
  for (const double drift_m_s : {0.05, -0.12}) {
    for (const double dt_s : {0.1, 1.0 / 30.0}) {
      DriftingVehicle vehicle;
      vehicle.dt_s = dt_s;
      vehicle.start();
      vehicle.fly(drift_m_s, static_cast<int>(10.0 * kTimeConstant_s / dt_s));
      EXPECT_NEAR(vehicle.observer.drift_m_s(), drift_m_s, 1e-3 * std::abs(drift_m_s));
    }
  }
}

TEST(DriftObserver, IsCriticallyDamped) {
  // Both poles at p: the step response is d·(1 − pⁿ·(1 + n·(1 − p)/p ·…)), in continuous time
  // d·(1 − (1 + t/τ)·exp(−t/τ)): it rises without overshoot, and is at 26 % after τ and 91 % after 4 τ.
  DriftingVehicle vehicle;
  vehicle.dt_s = 0.01;
  vehicle.start();
  double last = 0.0;
  for (int k = 1; k <= 1200; ++k) {
    vehicle.fly(0.1, 1);
    const double t = k * vehicle.dt_s / kTimeConstant_s;
    EXPECT_GE(vehicle.observer.drift_m_s(), last);
    EXPECT_NEAR(vehicle.observer.drift_m_s(), 0.1 * (1.0 - (1.0 + t) * std::exp(-t)), 1e-3);
    last = vehicle.observer.drift_m_s();
  }
  EXPECT_LE(last, 0.1 + 1e-12);
}

TEST(DriftObserver, StaysWithinItsLimit) {
  for (const double drift_m_s : {0.8, -0.8}) {
    DriftingVehicle vehicle;
    vehicle.start();
    for (int k = 0; k < 300; ++k) {
      vehicle.fly(drift_m_s, 1);
      EXPECT_LE(std::abs(vehicle.observer.drift_m_s()), kLimit_m_s);
    }
    EXPECT_NEAR(vehicle.observer.drift_m_s(), std::copysign(kLimit_m_s, drift_m_s), 1e-12);
  }
}

TEST(DriftObserver, RestartForgetsThePlaceAndKeepsTheDrift) {
  DriftingVehicle vehicle;
  vehicle.start();
  vehicle.fly(0.05, 300);
  vehicle.observer.restart();
  vehicle.observer.update(-7.0, 0.0, 0.1);  // another line, far away
  EXPECT_NEAR(vehicle.observer.drift_m_s(), 0.05, 1e-4);
}

}  // namespace
}  // namespace lineservo::servo
