#include "servo/task/command.h"

#include <gtest/gtest.h>

#include <limits>

namespace lineservo::servo {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Command, FiniteWhenEveryValueIs) {
  EXPECT_TRUE(is_finite(VelocityCommand{1.0, -2.0, 3.0, -4.0}));
  EXPECT_TRUE(is_finite(AttitudeCommand{0.1, -0.1, 0.2, 0.5}));
  EXPECT_TRUE(is_finite(LandCommand{}));
}

TEST(Command, OneBadValueIsEnough) {
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_FALSE(is_finite(VelocityCommand{bad, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(is_finite(VelocityCommand{0.0, bad, 0.0, 0.0}));
    EXPECT_FALSE(is_finite(VelocityCommand{0.0, 0.0, bad, 0.0}));
    EXPECT_FALSE(is_finite(VelocityCommand{0.0, 0.0, 0.0, bad}));
    EXPECT_FALSE(is_finite(AttitudeCommand{bad, 0.0, 0.0, 0.0}));
    EXPECT_FALSE(is_finite(AttitudeCommand{0.0, bad, 0.0, 0.0}));
    EXPECT_FALSE(is_finite(AttitudeCommand{0.0, 0.0, bad, 0.0}));
    EXPECT_FALSE(is_finite(AttitudeCommand{0.0, 0.0, 0.0, bad}));
  }
}

}  // namespace
}  // namespace lineservo::servo
