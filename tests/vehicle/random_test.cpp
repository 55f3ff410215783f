#include "vehicle/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::vehicle {
namespace {

TEST(Random, TheSameSeedGivesTheSameBitsOnEveryMachine) {
  Random random(1);
  std::uint64_t hash = 0;
  for (int i = 0; i < 1000; ++i) hash = hash * 31 + random.bits();
  Random again(1);
  std::uint64_t hash_again = 0;
  for (int i = 0; i < 1000; ++i) hash_again = hash_again * 31 + again.bits();
  EXPECT_EQ(hash, hash_again);
  EXPECT_NE(Random(1).bits(), Random(2).bits());
  EXPECT_NE(Random(1, 0).bits(), Random(1, 1).bits());
}

TEST(Random, NormalHasUnitMoments) {
  Random random(7);
  constexpr int kDraws = 200000;
  double sum = 0, squares = 0, fourth = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.01);
  EXPECT_NEAR(fourth / kDraws, 3.0, 0.1);
}

}  // namespace
}  // namespace lineservo::vehicle
