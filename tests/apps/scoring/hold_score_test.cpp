#include "apps/scoring/hold_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/scoring/percentile.h"

namespace lineservo::apps {
namespace {

using servo::Phase;

class HoldScoreTest : public ::testing::Test {
 protected:
  void add(Phase phase, double x_m, const Eigen::Vector3d& w_B = Eigen::Vector3d::Zero()) {
    TruthSample s;
    s.phase = phase;
    s.p_WB = {x_m, 0.0, 0.5};
    s.w_B = w_B;
    record_.truth.push_back(s);
  }
  FlightRecord record_;
};

TEST_F(HoldScoreTest, IsTheDistanceInHoverAlone) {
  add(Phase::follow, 9.0);
  add(Phase::hover, 0.1);
  add(Phase::hover, -0.3);
  add(Phase::finished, 9.0);
  EXPECT_NEAR(score_hold(record_, 0, {0, 0}).mean_m, 0.2, 1e-12);
  EXPECT_NEAR(score_hold(record_, 0, {0, 0}).max_m, 0.3, 1e-12);
}

TEST_F(HoldScoreTest, WithoutHoverIsNoNumber) {
  add(Phase::follow, 0.0);
  EXPECT_TRUE(std::isnan(score_hold(record_, 0, {0, 0}).mean_m));
  EXPECT_TRUE(std::isnan(score_hold(record_, 0, {0, 0}).max_m));
}

TEST_F(HoldScoreTest, TiltRateIsOfRollAndPitchUnderWayAlone) {
  add(Phase::take_off, 0.0, {9, 9, 9});
  add(Phase::align, 0.0, {9, 9, 9});
  add(Phase::follow, 0.0, {3, 4, 100});
  add(Phase::hover, 0.0, {0, 0, 100});
  add(Phase::land, 0.0, {9, 9, 9});
  EXPECT_NEAR(tilt_rate_rms_rad_s(record_), 5.0 / std::sqrt(2.0), 1e-12);
}

TEST_F(HoldScoreTest, TiltRateOfAFlightThatDidNotBeginIsNoNumber) {
  add(Phase::take_off, 0.0, {9, 9, 9});
  EXPECT_TRUE(std::isnan(tilt_rate_rms_rad_s(record_)));
}

TEST(Percentile, IsTheNearestRank) {
  EXPECT_EQ(percentile({3, 1, 2, 4}, 0.5), 2.0);
  EXPECT_EQ(percentile({3, 1, 2, 4}, 0.51), 3.0);
  EXPECT_EQ(percentile({3, 1, 2, 4}, 0.0), 1.0);
  EXPECT_EQ(percentile({3, 1, 2, 4}, 1.0), 4.0);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5)));
}

}  // namespace
}  // namespace lineservo::apps
