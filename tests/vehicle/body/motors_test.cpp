#include "vehicle/body/motors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::vehicle {
namespace {

constexpr double kStep_s = 1e-3;

TEST(Motors, AStepUpAndDownFollowsTheExponentialExactly) {
  const AirframeParameters iris;
  Motors motors(iris, kStep_s);
  for (int n = 1; n <= 50; ++n) {
    motors.step(PerRotor::Constant(700.0));
    EXPECT_NEAR(motors.speeds_rad_s()[2], 700.0 * (1.0 - std::exp(-n * kStep_s / 0.0125)), 1e-9);
  }
  const double top = motors.speeds_rad_s()[2];
  for (int n = 1; n <= 50; ++n) {
    motors.step(PerRotor::Constant(100.0));
    EXPECT_NEAR(motors.speeds_rad_s()[2], 100.0 + (top - 100.0) * std::exp(-n * kStep_s / 0.025), 1e-9);
  }
}

TEST(Motors, TheMiddleOfTheStepIsHalfAStepOn) {
  Motors motors(AirframeParameters{}, kStep_s);
  motors.step(PerRotor::Constant(500.0));
  EXPECT_NEAR(motors.mid_step_speeds_rad_s()[0], 500.0 * (1.0 - std::exp(-0.5 * kStep_s / 0.0125)), 1e-10);
}

TEST(Motors, CommandsBeyondWhatTheyCanDoAreCut) {
  Motors motors(AirframeParameters{}, kStep_s);
  for (int i = 0; i < 1000; ++i) motors.step(PerRotor(5000.0, 1100.0, 0.0, -300.0));
  EXPECT_NEAR((motors.speeds_rad_s() - PerRotor(1100.0, 1100.0, 0.0, 0.0)).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace lineservo::vehicle
