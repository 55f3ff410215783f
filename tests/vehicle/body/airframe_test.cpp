#include "vehicle/body/airframe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lineservo::vehicle {
namespace {

TEST(Airframe, TheIrisIsValidAndHoversWhereItShould) {
  const AirframeParameters iris;
  EXPECT_NO_THROW(iris.validate());
  // 4 k ω² = m g
  EXPECT_NEAR(4.0 * 5.84e-6 * std::pow(iris.hover_speed_rad_s(), 2), 1.5 * 9.81, 1e-12);
}

TEST(Airframe, EveryFaultIsNamedAtOnce) {
  AirframeParameters bad;
  bad.mass_kg = -1.0;
  bad.motor_lag_up_s = std::numeric_limits<double>::quiet_NaN();
  bad.rotors[0].spin = RotorPlacement::Spin::clockwise;
  try {
    bad.validate();
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("mass_kg is -1"));
    EXPECT_THAT(error.what(), testing::HasSubstr("motor_lag_up_s"));
    EXPECT_THAT(error.what(), testing::HasSubstr("two clockwise"));
  }
}

TEST(Airframe, AnInertiaThatNoBodyHasIsRefused) {
  AirframeParameters bad;
  bad.inertia_kg_m2 << 0.01, 0.01, 0.03;
  EXPECT_THROW(bad.validate(), std::invalid_argument);
}

TEST(Airframe, RotorsThatOverlapAreRefused) {
  AirframeParameters bad;
  bad.rotor_radius_m = 0.14;  // the front and rear rotors are 0.261 m apart
  EXPECT_THROW(bad.validate(), std::invalid_argument);
}

TEST(Airframe, RotorsThatCannotMakeEveryMomentAreRefused) {
  using Spin = RotorPlacement::Spin;
  AirframeParameters in_a_row, same_spin_on_a_side;
  in_a_row.rotors = {{{-0.6, 0.0, Spin::counter_clockwise},
                      {-0.2, 0.0, Spin::clockwise},
                      {0.2, 0.0, Spin::counter_clockwise},
                      {0.6, 0.0, Spin::clockwise}}};
  same_spin_on_a_side.rotors = {{{0.2, 0.2, Spin::counter_clockwise},
                                 {-0.2, 0.2, Spin::counter_clockwise},
                                 {0.2, -0.2, Spin::clockwise},
                                 {-0.2, -0.2, Spin::clockwise}}};
  EXPECT_THROW(in_a_row.validate(), std::invalid_argument);
  EXPECT_THROW(same_spin_on_a_side.validate(), std::invalid_argument);
}

TEST(Airframe, ACentreOfMassOutsideTheRotorsIsRefused) {
  AirframeParameters bad;
  for (RotorPlacement& rotor : bad.rotors) rotor.x_m += 0.2;
  EXPECT_THROW(bad.validate(), std::invalid_argument);
}

TEST(Airframe, OneThatCannotLiftItselfIsRefused) {
  AirframeParameters heavy;
  heavy.mass_kg = 3.0;
  EXPECT_THROW(heavy.validate(), std::invalid_argument);
}

TEST(Airframe, SpacingAndDiagonalOfASquareOfRotors) {
  AirframeParameters square;
  using Spin = RotorPlacement::Spin;
  square.rotors = {{{0.1, -0.1, Spin::counter_clockwise},
                    {-0.1, 0.1, Spin::counter_clockwise},
                    {0.1, 0.1, Spin::clockwise},
                    {-0.1, -0.1, Spin::clockwise}}};
  EXPECT_NEAR(square.rotor_spacing_m(), 0.2, 1e-12);
  EXPECT_NEAR(square.rotor_diagonal_m(), 0.2 * std::sqrt(2.0), 1e-12);
}

TEST(Airframe, ALoadIsOnMassAndInertia) {
  AirframeParameters iris;
  iris.load_factor = 1.1;
  const AirframeParameters flown = iris.loaded();
  EXPECT_NEAR(flown.mass_kg, 1.65, 1e-12);
  EXPECT_NEAR((flown.inertia_kg_m2 - 1.1 * iris.inertia_kg_m2).norm(), 0.0, 1e-12);
  EXPECT_EQ(flown.load_factor, 1.0);
  iris.load_factor = 1.7;  // 25 N of weight and 28 N of thrust
  EXPECT_THROW(iris.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
