#include "servo/law/grid_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/servo/law/follower_views.h"

namespace lineservo::servo {
namespace {

using features::degrees;
using features::kPi;
using features::LineFeature;
using features::radians;
using testing::attitude;
using testing::kFollowerGoal;

LineFeature vertical(double offset_m, double theta_rad = 0.0) {
  LineFeature line;
  line.rho = offset_m / kFollowerGoal.height_m;
  line.theta_rad = theta_rad;
  line.covariance = 1e-6 * Eigen::Matrix2d::Identity();
  return line;
}

/// y = −forward in the image.
LineFeature horizontal(double forward_m) {
  LineFeature line = vertical(-forward_m, 0.5 * kPi);
  return line;
}

Observation view(std::vector<LineFeature> lines, int frame = 0) {
  Observation o = testing::empty_view();
  o.features.law.lines = std::move(lines);
  o.now = o.captured = std::chrono::milliseconds(100 * frame);
  return o;
}

AttitudeCommand hover(GridLaw& law, const Observation& o) {
  return std::get<AttitudeCommand>(*law.hover(o, {0.0, 0.5}));
}

// The first frame has neither integral nor derivative: K_p 0.05 m = 0.0051 rad.
TEST(GridLaw, RollAndYawByHand) {
  GridLaw law({});
  const AttitudeCommand c = attitude(law, view({vertical(0.05, radians(0.5))}));
  EXPECT_NEAR(c.roll_rad, 0.0051, 1e-9);
  EXPECT_NEAR(c.yaw_rate_rad_s, -radians(0.5), 1e-9);
  EXPECT_EQ(c.height_m, 0.5);
}

TEST(GridLaw, MovesAndTurnsTowardsTheLine) {
  for (const double side : {-1.0, 1.0}) {
    GridLaw law({});
    const AttitudeCommand c = attitude(law, view({vertical(side * 0.1, side * 0.01)}));
    EXPECT_GT(side * c.roll_rad, 0.0);
    EXPECT_LT(side * c.yaw_rate_rad_s, 0.0);
  }
}

TEST(GridLaw, IsClippedToOneDegreeAndOneDegreeASecond) {
  for (const double side : {-1.0, 1.0}) {
    GridLaw law({});
    const AttitudeCommand c = attitude(law, view({vertical(side * 0.4, side * 0.2)}), {side * 3.0, 0.5});
    EXPECT_NEAR(degrees(c.roll_rad), side * 1.0, 1e-9);
    EXPECT_NEAR(degrees(c.pitch_rad), side * 1.0, 1e-9);
    EXPECT_NEAR(degrees(c.yaw_rate_rad_s), -side * 1.0, 1e-9);
  }
}

// trim 0.1 m/s and K_d times what is missing.
TEST(GridLaw, TheImaginaryLineLeads) {
  GridLaw law({});
  Observation o = view({vertical(0.0)});
  EXPECT_NEAR(attitude(law, o).pitch_rad, 0.0038, 1e-12);
  o.estimate.v_H_m_s.x() = 0.06;
  EXPECT_NEAR(attitude(law, o).pitch_rad, 0.0038 + 0.125 * 0.04, 1e-12);
}

TEST(GridLaw, HoversBackOntoTheHorizontalLine) {
  for (const double side : {-1.0, 1.0}) {
    GridLaw law({});
    const AttitudeCommand c = hover(law, view({vertical(0.0), horizontal(side * 0.1)}));
    EXPECT_NEAR(c.pitch_rad, side * 0.0102, 1e-9);  // forward is nose down
    EXPECT_NEAR(c.roll_rad, 0.0, 1e-9);
  }
}

TEST(GridLaw, OfTwoHorizontalLinesTheNearerIsTheGoalAndStaysIt) {
  GridLaw law({});
  hover(law, view({vertical(0.0), horizontal(0.3), horizontal(0.1)}));
  const AttitudeCommand c = hover(law, view({vertical(0.0), horizontal(0.08), horizontal(0.28)}, 1));
  EXPECT_GT(c.pitch_rad, -radians(1.0));
  EXPECT_LT(c.pitch_rad, 0.102 * 0.1 + 0.01 * 0.01);
}

TEST(GridLaw, HoversOnTheSpeedWhereThereIsNoHorizontalLine) {
  GridLaw law({});
  EXPECT_NEAR(hover(law, view({vertical(0.0)})).pitch_rad, -0.125 * 0.1, 1e-9);
}

TEST(GridLaw, IgnoresALineFarOffTheTrackedOne) {
  GridLaw law({});
  for (int k = 0; k < 5; ++k) attitude(law, view({vertical(0.02)}, k));
  const AttitudeCommand c = attitude(law, view({vertical(0.4), vertical(0.02)}, 5));
  EXPECT_NEAR(c.roll_rad, 0.102 * 0.02, 0.0005);
}

void expect_level(const AttitudeCommand& c) {
  EXPECT_EQ(c.roll_rad, 0.0);
  EXPECT_EQ(c.pitch_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(c.height_m, kFollowerGoal.height_m);
}

TEST(GridLaw, WithoutALineItKeepsLevel) {
  GridLaw law({});
  expect_level(attitude(law, view({})));
  LineFeature broken = vertical(0.1);
  broken.rho = std::nan("");
  expect_level(attitude(law, view({broken}, 1)));
  EXPECT_EQ(attitude(law, view({horizontal(0.1)}, 2)).roll_rad, 0.0);
}

TEST(GridLaw, WithoutALineItGoesStraightOnOverAJunction) {
  GridLaw law({});
  const AttitudeCommand c = attitude(law, testing::empty_view(features::JunctionCode::start));
  EXPECT_NEAR(c.pitch_rad, 0.0038, 1e-12);
  EXPECT_EQ(c.roll_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
}

TEST(GridLaw, ResetForgets) {
  GridLaw law({}), fresh({});
  for (int k = 0; k < 10; ++k) attitude(law, view({vertical(0.1 - 0.01 * k)}, k));
  law.reset();
  EXPECT_EQ(attitude(law, view({vertical(0.05)}, 11)).roll_rad,
            attitude(fresh, view({vertical(0.05)}, 11)).roll_rad);
}

// x cosθ + y sinθ = ρ holds for the turned point (y, −x) on the turned line, on either branch.
TEST(GridLaw, AQuarterTurnTakesPointsAlong) {
  for (const double theta : {-1.4, -0.3, 0.0, 0.7, 1.5}) {
    LineFeature line = vertical(0.1, theta);
    const double x = line.rho * std::cos(theta) - 0.3 * std::sin(theta);
    const double y = line.rho * std::sin(theta) + 0.3 * std::cos(theta);
    const LineFeature turned = quarter_turned(line);
    EXPECT_GT(turned.theta_rad, -0.5 * kPi);
    EXPECT_LE(turned.theta_rad, 0.5 * kPi);
    EXPECT_NEAR(y * std::cos(turned.theta_rad) - x * std::sin(turned.theta_rad), turned.rho, 1e-12);
  }
}

}  // namespace
}  // namespace lineservo::servo
