#include "servo/law/carrot_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/servo/law/follower_views.h"

namespace lineservo::servo {
namespace {

using features::degrees;
using testing::at_px;
using testing::attitude;
using testing::boundary_view;
using testing::kFollowerGoal;

/// A line straight ahead, so many pixels to the right of the centre.
Observation forward_line(double off_px) {
  return boundary_view(at_px(off_px, 230.0), at_px(off_px, -230.0));
}

// u = 3/s · atan2(50, 100) = 3/s · 26.565°.
TEST(CarrotLaw, YawRateByHand) {
  CarrotLaw law({});
  EXPECT_NEAR(degrees(attitude(law, forward_line(-50.0)).yaw_rate_rad_s), 79.695, 1e-3);
  EXPECT_NEAR(degrees(attitude(law, forward_line(50.0)).yaw_rate_rad_s), -79.695, 1e-3);
}

TEST(CarrotLaw, PitchIsConstantAndThereIsNoRoll) {
  CarrotLaw law({.speed_hold_rad_per_m_s = 0.0});
  for (const double off_px : {-100.0, 0.0, 60.0}) {
    const AttitudeCommand c = attitude(law, forward_line(off_px), {0.46, 0.5});
    EXPECT_NEAR(degrees(c.pitch_rad), 1.0, 1e-9);
    EXPECT_EQ(c.roll_rad, 0.0);
    EXPECT_EQ(c.height_m, 0.5);
  }
  EXPECT_NEAR(degrees(attitude(law, forward_line(0.0), {0.23, 0.5}).pitch_rad), 0.5, 1e-9);
}

TEST(CarrotLaw, HoldsTheSpeed) {
  CarrotLaw law({});
  Observation slow = forward_line(0.0);
  const double trim = attitude(law, slow).pitch_rad;
  slow.estimate.v_H_m_s.x() -= 0.05;
  EXPECT_NEAR(attitude(law, slow).pitch_rad, trim + 0.1 * 0.05, 1e-12);
}

TEST(CarrotLaw, WithoutWayPointsItKeepsLevel) {
  CarrotLaw law({});
  const AttitudeCommand c = attitude(law, testing::empty_view());
  EXPECT_EQ(c.roll_rad, 0.0);
  EXPECT_EQ(c.pitch_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
  EXPECT_EQ(c.height_m, kFollowerGoal.height_m);
}

TEST(CarrotLaw, WithoutALineItGoesStraightOnOverAJunction) {
  CarrotLaw law({});
  const AttitudeCommand c = attitude(law, testing::empty_view(features::JunctionCode::start));
  EXPECT_GT(c.pitch_rad, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
}

// With the drag D of the body and h δ / f metres to the carrot, s (s + D)(s + κ) + κ D v f / (h δ) has its
// roots on the left as long as κ + D > v f / (h δ) (Routh): the default holds that at 0.46 m/s.
TEST(CarrotLaw, TheDefaultGainIsStableAtThePublishedSpeed) {
  const CarrotOptions options;
  const double carrot_m = options.delta_px / testing::kFocal_px * kFollowerGoal.height_m;
  EXPECT_GT(options.kappa_per_s, options.pitch_speed_m_s / carrot_m);
}

}  // namespace
}  // namespace lineservo::servo
