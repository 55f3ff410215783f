#include "servo/law/height_rate.h"

#include <gtest/gtest.h>

namespace lineservo::servo {
namespace {

TEST(HeightRate, IsProportionalToWhatIsMissing) {
  EXPECT_DOUBLE_EQ(height_rate(0.4, 0.5), 1.5 * (0.5 - 0.4));
  EXPECT_DOUBLE_EQ(height_rate(0.6, 0.5), 1.5 * (0.5 - 0.6));
  EXPECT_DOUBLE_EQ(height_rate(0.5, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(height_rate(0.4, 0.5, 2.0), 2.0 * (0.5 - 0.4));
}

TEST(HeightRate, IsLimitedBothWays) {
  EXPECT_DOUBLE_EQ(height_rate(0.0, 5.0), 0.4);
  EXPECT_DOUBLE_EQ(height_rate(5.0, 0.0), -0.4);
  EXPECT_DOUBLE_EQ(height_rate(0.0, 5.0, 1.5, 0.1), 0.1);
}

}  // namespace
}  // namespace lineservo::servo
