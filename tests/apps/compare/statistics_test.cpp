#include "apps/compare/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Newcombe (1998), Tab. I: 81 of 263, and 0 of 20, 1 of 29.
TEST(Wilson, GivesThePublishedIntervals) {
  EXPECT_NEAR(wilson95(81, 263).low, 0.2553, 5e-5);
  EXPECT_NEAR(wilson95(81, 263).high, 0.3662, 5e-5);
  EXPECT_EQ(wilson95(0, 20).low, 0.0);
  EXPECT_NEAR(wilson95(0, 20).high, 0.1611, 5e-5);
  EXPECT_NEAR(wilson95(1, 29).low, 0.0061, 5e-5);
  EXPECT_NEAR(wilson95(1, 29).high, 0.1718, 5e-5);
}

TEST(Wilson, IsTheSameFromBothEnds) {
  for (long k = 0; k <= 10; ++k) {
    EXPECT_NEAR(wilson95(k, 10).low, 1.0 - wilson95(10 - k, 10).high, 1e-12);
    EXPECT_LE(wilson95(k, 10).low, static_cast<double>(k) / 10.0);
  }
}

TEST(Wilson, WithoutATrialIsNoNumber) {
  EXPECT_TRUE(std::isnan(wilson95(0, 0).low));
  EXPECT_TRUE(std::isnan(wilson95(0, 0).high));
}

TEST(MeanOf, PassesOverWhatIsNoNumber) {
  EXPECT_DOUBLE_EQ(mean_of({1.0, kNaN, 3.0}), 2.0);
  EXPECT_TRUE(std::isnan(mean_of({kNaN})));
  EXPECT_TRUE(std::isnan(mean_of({})));
}

TEST(PairedDifference, OfAConstantIsThatConstant) {
  const PairedDifference d = paired_difference(std::vector<double>(12, 0.25));
  EXPECT_DOUBLE_EQ(d.mean, 0.25);
  EXPECT_DOUBLE_EQ(d.ci95.low, 0.25);
  EXPECT_DOUBLE_EQ(d.ci95.high, 0.25);
  EXPECT_EQ(d.pairs, 12u);
}

TEST(PairedDifference, WithoutPairsOrWithOneHasNoInterval) {
  EXPECT_TRUE(std::isnan(paired_difference({}).mean));
  EXPECT_EQ(paired_difference({}).pairs, 0u);
  EXPECT_EQ(paired_difference({0.5}).mean, 0.5);
  EXPECT_TRUE(std::isnan(paired_difference({0.5}).ci95.low));
}

TEST(PairedDifference, IsTheSameEveryTime) {
  const std::vector<double> values = {0.1, 0.4, -0.2, 0.3, 0.05};
  EXPECT_EQ(paired_difference(values).ci95.low, paired_difference(values).ci95.low);
  EXPECT_EQ(paired_difference(values).ci95.high, paired_difference(values).ci95.high);
}

// The percentile interval of n = 40 normal values holds the true mean in about 94 of 100 cases.
TEST(PairedDifference, HoldsTheTrueMeanAboutAsOftenAsItSays) {
  vehicle::Random random(5);
  int held = 0;
  for (int k = 0; k < 300; ++k) {
    std::vector<double> values(40);
    for (double& v : values) v = 1.0 + random.normal();
    const Interval ci = paired_difference(values).ci95;
    held += ci.low <= 1.0 && 1.0 <= ci.high ? 1 : 0;
  }
  EXPECT_GE(held, 270);
  EXPECT_LE(held, 297);
}

}  // namespace
}  // namespace lineservo::apps
