#include "vehicle/autopilot/rotor_lead.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/body/motors.h"

namespace lineservo::vehicle {
namespace {

TEST(RotorLead, MakesTheMotorsAsFastDownAsUp) {
  const AirframeParameters iris;
  RotorLead lead(iris, 0.0125, 0.005);
  Motors motors(iris, 0.001);
  const auto run_period = [&](double speed_rad_s) {
    const PerRotor thrust = PerRotor::Constant(iris.thrust_coefficient_N_s2 * speed_rad_s * speed_rad_s);
    const PerRotor command = lead.command_rad_s(thrust);
    for (int i = 0; i < 5; ++i) motors.step(command);
    return motors.speeds_rad_s()[0];
  };
  for (int i = 0; i < 60; ++i) run_period(800.0);
  EXPECT_NEAR(motors.speeds_rad_s()[0], 800.0, 1e-6);
  for (int n = 1; n < 10; ++n) {
    EXPECT_NEAR(run_period(600.0), 600.0 + 200.0 * std::exp(-n * 0.005 / 0.0125), 1e-6);
  }
}

TEST(RotorLead, NeverCommandsBeyondTheMotors) {
  const AirframeParameters iris;
  RotorLead lead(iris, 0.001, 0.005);
  EXPECT_LE(lead.command_rad_s(PerRotor::Constant(7.0)).maxCoeff(), iris.max_rotor_speed_rad_s);
  EXPECT_GE(lead.command_rad_s(PerRotor::Constant(0.0)).minCoeff(), 0.0);
}

}  // namespace
}  // namespace lineservo::vehicle
