#include "vehicle/autopilot/mixer.h"

#include <gtest/gtest.h>

namespace lineservo::vehicle {
namespace {

const AirframeParameters kIris;

TEST(Mixer, WhatTheRotorsCanDoComesBackExactly) {
  const Mixer mixer(kIris);
  const ThrustAndTorque wanted{16.0, {0.3, -0.2, 0.05}};
  const ThrustAndTorque got = mixer.result(mixer.rotor_thrusts_N(wanted));
  EXPECT_NEAR(got.thrust_N, 16.0, 1e-12);
  EXPECT_NEAR((got.torque_B_Nm - wanted.torque_B_Nm).norm(), 0.0, 1e-12);
}

TEST(Mixer, ARollToTheRightLoadsTheLeftRotors) {
  const PerRotor f = Mixer(kIris).rotor_thrusts_N({15.0, {0.5, 0.0, 0.0}});
  for (int i = 0; i < kRotors; ++i) {
    EXPECT_EQ(f[i] > 15.0 / 4, kIris.rotors[static_cast<std::size_t>(i)].y_m > 0.0);
  }
}

TEST(Mixer, YawIsGivenUpFirst) {
  const Mixer mixer(kIris);
  const ThrustAndTorque got = mixer.result(mixer.rotor_thrusts_N({14.7, {0.6, 0.3, 5.0}}));
  EXPECT_NEAR(got.thrust_N, 14.7, 1e-9);
  EXPECT_NEAR(got.torque_B_Nm.x(), 0.6, 1e-9);
  EXPECT_NEAR(got.torque_B_Nm.y(), 0.3, 1e-9);
  EXPECT_GT(got.torque_B_Nm.z(), 0.0);
  EXPECT_LT(got.torque_B_Nm.z(), 5.0);
}

TEST(Mixer, ThenThrustSoThatRollAndPitchStay) {
  const Mixer mixer(kIris);
  for (const double thrust_N : {0.0, 100.0}) {
    const ThrustAndTorque got = mixer.result(mixer.rotor_thrusts_N({thrust_N, {1.0, -0.4, 0.0}}));
    EXPECT_NEAR(got.torque_B_Nm.x(), 1.0, 1e-9) << thrust_N;
    EXPECT_NEAR(got.torque_B_Nm.y(), -0.4, 1e-9) << thrust_N;
    EXPECT_NEAR(got.torque_B_Nm.z(), 0.0, 1e-9) << thrust_N;
  }
}

TEST(Mixer, BeyondEverythingRollAndPitchKeepTheirDirection) {
  const Mixer mixer(kIris);
  const ThrustAndTorque got = mixer.result(mixer.rotor_thrusts_N({14.7, {30.0, 15.0, 0.0}}));
  EXPECT_GT(got.torque_B_Nm.x(), 1.0);
  EXPECT_NEAR(got.torque_B_Nm.y() / got.torque_B_Nm.x(), 0.5, 1e-6);
}

TEST(Mixer, NoRotorEverLeavesItsRange) {
  const Mixer mixer(kIris);
  for (const double T : {-5.0, 0.0, 14.0, 60.0}) {
    for (const double roll : {-3.0, 0.0, 1.0}) {
      for (const double yaw : {-2.0, 0.1}) {
        const PerRotor f = mixer.rotor_thrusts_N({T, {roll, 0.5, yaw}});
        EXPECT_GE(f.minCoeff(), mixer.least_thrust_N());
        EXPECT_LE(f.maxCoeff(), mixer.greatest_thrust_N());
      }
    }
  }
}

}  // namespace
}  // namespace lineservo::vehicle
