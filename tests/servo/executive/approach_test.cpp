#include "servo/executive/approach.h"

#include <gtest/gtest.h>

namespace lineservo::servo {
namespace {

const ApproachOptions kOptions{0.5, 0.2, 0.05};

TEST(Approach, TheWayAtTheSpeedIsTheWayToAnswerAndToBrake) {
  for (const double end_m_s : {0.0, 0.2}) {
    for (const double ahead_m : {0.1, 0.4, 2.0}) {
      const double v = braking_speed(ahead_m, end_m_s, kOptions);
      EXPECT_NEAR(v * 0.2 + (v * v - end_m_s * end_m_s) / (2.0 * 0.5), ahead_m, 1e-12);
    }
  }
}

TEST(Approach, IsNeverSlowerThanAskedForAtTheEnd) {
  EXPECT_EQ(braking_speed(0.0, 0.0, kOptions), 0.05);
  EXPECT_EQ(braking_speed(-0.3, 0.0, kOptions), 0.05);
  EXPECT_EQ(braking_speed(-0.3, 0.2, kOptions), 0.2);
}

}  // namespace
}  // namespace lineservo::servo
