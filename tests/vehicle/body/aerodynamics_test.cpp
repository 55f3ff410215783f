#include "vehicle/body/aerodynamics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::vehicle {
namespace {

AirframeParameters without_drag() {
  AirframeParameters a;
  a.rotor_drag_N_per_rad_s_m_s = 0.0;
  a.body_drag_area_m2 = 0.0;
  return a;
}

AirMotion high_up() {
  AirMotion motion;
  motion.height_m = 1e6;
  return motion;
}

TEST(Aerodynamics, InHoverTheThrustIsTheWeightAndThereIsNoMoment) {
  const AirframeParameters iris;
  const Wrench w = Aerodynamics(iris).wrench(PerRotor::Constant(iris.hover_speed_rad_s()), high_up());
  EXPECT_NEAR((w.force_B_N - Eigen::Vector3d(0, 0, 1.5 * 9.81)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(w.torque_B_Nm.norm(), 0.0, 1e-12);
}

TEST(Aerodynamics, OneRotorPushesAtItsPlaceAndTurnsTheBodyAgainstItsSpin) {
  const Aerodynamics air(without_drag());
  const double T = 5.84e-6 * 600.0 * 600.0;
  const Wrench front_right = air.wrench(PerRotor(600, 0, 0, 0), high_up());  // counter-clockwise
  EXPECT_NEAR((front_right.torque_B_Nm - Eigen::Vector3d(-0.22 * T, -0.13 * T, -0.06 * T)).norm(), 0.0, 1e-9);
  const Wrench front_left = air.wrench(PerRotor(0, 0, 600, 0), high_up());  // clockwise
  EXPECT_NEAR((front_left.torque_B_Nm - Eigen::Vector3d(0.22 * T, -0.13 * T, 0.06 * T)).norm(), 0.0, 1e-9);
}

TEST(Aerodynamics, RotorDragGoesWithSpeedOfRotorAndAir) {
  AirframeParameters a;
  a.body_drag_area_m2 = 0.0;
  AirMotion motion = high_up();
  motion.v_air_B << 2.0, -1.0, 3.0;
  const Wrench w = Aerodynamics(a).wrench(PerRotor::Constant(700.0), motion);
  // 4 c_d ω v, none along the axis
  EXPECT_NEAR(w.force_B_N.x(), -4 * 1.75e-4 * 700.0 * 2.0, 1e-12);
  EXPECT_NEAR(w.force_B_N.y(), 4 * 1.75e-4 * 700.0 * 1.0, 1e-12);
  EXPECT_NEAR(w.force_B_N.z(), 4 * 5.84e-6 * 700.0 * 700.0, 1e-9);
}

TEST(Aerodynamics, RotorDragBrakesTheYawRate) {
  AirMotion motion = high_up();
  motion.w_B << 0.0, 0.0, 1.5;
  const Wrench w = Aerodynamics(AirframeParameters{}).wrench(PerRotor::Constant(700.0), motion);
  const double sum_r2 = 2 * (0.13 * 0.13 + 0.22 * 0.22) + 2 * (0.13 * 0.13 + 0.20 * 0.20);
  EXPECT_NEAR(w.torque_B_Nm.z(), -1.75e-4 * 700.0 * 1.5 * sum_r2, 1e-12);
}

TEST(Aerodynamics, BodyDragIsQuadraticAndAgainstTheMotion) {
  AirMotion motion = high_up();
  motion.v_air_B << 3.0, 0.0, 4.0;
  const Wrench w = Aerodynamics(AirframeParameters{}).wrench(PerRotor::Zero(), motion);
  const double F = 0.5 * 1.225 * 0.02 * 25.0;
  EXPECT_NEAR((w.force_B_N - Eigen::Vector3d(-0.6 * F, 0.0, -0.8 * F)).norm(), 0.0, 1e-12);
}

TEST(Aerodynamics, FarRotorsLeaveTheGroundEffectOfCheesemanAndBennett) {
  AirframeParameters wide;
  for (RotorPlacement& r : wide.rotors) {
    r.x_m *= 1e4;
    r.y_m *= 1e4;
  }
  const Aerodynamics air(wide);
  for (const double z : {0.1, 0.3, 1.0}) {
    const double q = 0.128 / (4.0 * z);
    EXPECT_NEAR(air.ground_effect(z), 1.0 / (1.0 - q * q), 1e-9);
  }
}

TEST(Aerodynamics, GroundEffectOfTheWholeVehicleAgainstTheFormula) {
  const AirframeParameters iris;
  const double d = iris.rotor_spacing_m(), b = iris.rotor_diagonal_m(), R = 0.128, z = 0.5;
  const auto source = [&](double a2) { return z / std::pow(a2 + 4 * z * z, 1.5); };
  const double expected = 1.0 / (1.0 - std::pow(R / (4 * z), 2) - R * R * source(d * d) -
                                 R * R / 2 * source(2 * d * d) - 2 * R * R * 2.0 * source(b * b));
  EXPECT_NEAR(Aerodynamics(iris).ground_effect(z), expected, 1e-12);
  EXPECT_GT(expected, 1.03);
  EXPECT_LT(expected, 1.05);
}

TEST(Aerodynamics, GroundEffectFallsWithHeightAndIsFiniteOnTheFloor) {
  const Aerodynamics air{AirframeParameters{}};
  EXPECT_EQ(air.ground_effect(0.0), air.ground_effect(0.064));
  EXPECT_LT(air.ground_effect(0.0), 2.0);
  for (double z = 0.1; z < 3.0; z += 0.1) EXPECT_GT(air.ground_effect(z), air.ground_effect(z + 0.1));
  EXPECT_NEAR(air.ground_effect(50.0), 1.0, 1e-5);
}

TEST(Aerodynamics, AWeakMotorGivesItsShareOfThrustAndTorque) {
  AirframeParameters weak = without_drag();
  weak.thrust_factors[2] = 0.8;
  const PerRotor front_left(0, 0, 600, 0);
  const Wrench full = Aerodynamics(without_drag()).wrench(front_left, high_up());
  const Wrench less = Aerodynamics(weak).wrench(front_left, high_up());
  EXPECT_NEAR((less.force_B_N - 0.8 * full.force_B_N).norm(), 0.0, 1e-12);
  EXPECT_NEAR((less.torque_B_Nm - 0.8 * full.torque_B_Nm).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace lineservo::vehicle
