#include "servo/executive/turn_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::servo {
namespace {

const TurnOptions kOptions{2.0, 0.6, 1.0};

TEST(TurnProfile, ThreeRegimes) {
  EXPECT_NEAR(turn_rate(0.01, kOptions), 2.0 * 0.01, 1e-12);  // proportional near the end
  EXPECT_NEAR(turn_rate(1.5, kOptions), 0.6, 1e-12);          // at the limit far from it
  const TurnOptions steep{20.0, 5.0, 1.0};
  EXPECT_NEAR(turn_rate(0.5, steep), std::sqrt(2.0 * 1.0 * 0.5), 1e-12);  // on the braking curve between
}

TEST(TurnProfile, TheTimeIsThatAtTheLimitAndTheBraking) {
  EXPECT_NEAR(turn_time_s(-1.5, kOptions), 1.5 / 0.6 + 0.5 * 0.6 / 1.0, 1e-12);
}

TEST(TurnProfile, IsOddAndZeroAtTheEnd) {
  EXPECT_EQ(turn_rate(0.0, kOptions), 0.0);
  for (const double angle_rad : {0.001, 0.05, 0.3, 1.57, 3.0}) {
    EXPECT_EQ(turn_rate(-angle_rad, kOptions), -turn_rate(angle_rad, kOptions));
    EXPECT_GT(turn_rate(angle_rad, kOptions), 0.0);
  }
}

TEST(TurnProfile, AQuarterTurnEndsWithoutOvershootAndBrakesWithinTheLimit) {
  constexpr double kDt_s = 0.01;
  double left_rad = 1.5708, rate = turn_rate(left_rad, kOptions);
  for (int k = 0; k < 600; ++k) {
    left_rad -= rate * kDt_s;
    EXPECT_GE(left_rad, 0.0);
    const double slower = turn_rate(left_rad, kOptions);
    EXPECT_LE(slower, rate + 1e-12);
    EXPECT_LE(rate - slower, 2.0 * kOptions.rate_limit_rad_s * kDt_s + 1e-12);  // ω̇ = gain·ω
    rate = slower;
  }
  EXPECT_LT(left_rad, 0.001);
}

}  // namespace
}  // namespace lineservo::servo
