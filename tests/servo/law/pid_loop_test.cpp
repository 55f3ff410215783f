#include "servo/law/pid_loop.h"

#include <gtest/gtest.h>

namespace lineservo::servo {
namespace {

constexpr PidGains kGains{2.0, 0.5, 0.1};

// e = 1, 3, 3 at steps of 0.5 s:  P + I + D = 2 + 0 + 0;  6 + 0.5·1.5 + 0.1·4;  6 + 0.5·3 + 0.
TEST(PidLoop, SequenceByHand) {
  PidLoop loop;
  EXPECT_NEAR(loop.update(1.0, 0.5, kGains, 100.0), 2.0, 1e-12);
  EXPECT_NEAR(loop.update(3.0, 0.5, kGains, 100.0), 6.0 + 0.75 + 0.4, 1e-12);
  EXPECT_NEAR(loop.update(3.0, 0.5, kGains, 100.0), 6.0 + 1.5, 1e-12);
}

TEST(PidLoop, IsClippedOnBothSides) {
  for (const double side : {-1.0, 1.0}) {
    PidLoop loop;
    EXPECT_EQ(loop.update(side * 10.0, 0.1, kGains, 1.5), side * 1.5);
  }
}

TEST(PidLoop, TheIntegralDoesNotWindUp) {
  PidLoop loop;
  for (int k = 0; k < 1000; ++k) loop.update(10.0, 0.1, kGains, 1.5);
  loop.update(0.1, 0.1, kGains, 1.5);
  EXPECT_LT(loop.update(0.1, 0.1, kGains, 1.5), 0.3);  // 2·0.1 and next to no integral
}

TEST(PidLoop, WithoutTimeNothingAccumulates) {
  PidLoop loop;
  loop.update(1.0, 0.1, kGains, 100.0);
  const double before = loop.update(1.0, 0.1, kGains, 100.0);
  EXPECT_EQ(loop.update(1.0, 0.0, kGains, 100.0), before);
}

TEST(PidLoop, ResetForgets) {
  PidLoop loop;
  for (int k = 0; k < 5; ++k) loop.update(k, 0.1, kGains, 100.0);
  loop.reset();
  EXPECT_NEAR(loop.update(1.0, 0.1, kGains, 100.0), 2.0, 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
