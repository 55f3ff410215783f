#include "apps/scoring/track_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "features/geometry/angles.h"
#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using features::kPi;
using features::radians;
using servo::Phase;
using testing::plan_on;
using testing::shipped_layout;

constexpr double kSample_s = 0.01;

/// Builds the record of a flight of a13: leg 1 from (0.6, 0.6) along x, leg 2 from (4.2, 0.6) along y.
class Recorder {
 public:
  /// One sample every 10 ms.
  Recorder& add(Phase phase, int step, double x_m, double y_m, double heading_rad, double speed_m_s = 0.1) {
    TruthSample s;
    s.t = kTruthPeriod * static_cast<long>(record_.truth.size() + 1);
    s.p_WB = {x_m, y_m, 0.5};
    s.v_W = {speed_m_s, 0.0, 0.0};
    s.heading_rad = heading_rad;
    s.phase = phase;
    s.step = step;
    record_.truth.push_back(s);
    return *this;
  }
  /// Along leg 1 or 2 with a lateral offset to the left, a function of the time since.
  Recorder& fly(int leg, double seconds, const std::function<double(double)>& left_m, int step) {
    const int samples = static_cast<int>(std::lround(seconds / kSample_s));
    for (int k = 0; k < samples; ++k) {
      const double along_m = 0.5 + 2.0 * k / samples, left = left_m(k * kSample_s);
      if (leg == 1) add(Phase::follow, step, 0.6 + along_m, 0.6 + left, 0.0);
      if (leg == 2) add(Phase::follow, step, 4.2 - left, 0.6 + along_m, kPi / 2);
    }
    return *this;
  }
  const FlightRecord& record() const { return record_; }

 private:
  FlightRecord record_;
};

class TrackScoreTest : public ::testing::Test {
 protected:
  TrackScore score() const { return score_track(flight_.record(), route_); }
  std::optional<Rest> rest() const {
    return find_rest(flight_.record(), route_.closing_steps.back(), {4.2, 7.4});
  }
  Recorder& hold(int samples, Phase phase, int step, double speed_m_s, double x_m = 4.2, double y_m = 7.41) {
    for (int k = 0; k < samples; ++k) flight_.add(phase, step, x_m, y_m, kPi / 2, speed_m_s);
    return flight_;
  }

  const vehicle::Layout floor_ = shipped_layout("warehouse");
  const RouteTruth route_ = route_truth(floor_, plan_on(floor_, "a13"));
  Recorder flight_;
};

double constant(double /*t_s*/) {
  return 0.03;
}

TEST_F(TrackScoreTest, NothingBeforeFollowCounts) {
  flight_.add(Phase::take_off, 0, 0.6, 0.9, 0.0).add(Phase::align, 0, 0.6, 0.9, 0.0);
  EXPECT_TRUE(score().legs.empty());
  EXPECT_TRUE(std::isnan(score().all.rmse_m));
  EXPECT_TRUE(std::isnan(score().all.max_m));
}

TEST_F(TrackScoreTest, AConstantOffsetIsEveryStatisticButTheDeviation) {
  flight_.fly(1, 2.0, constant, 0);
  const TrackScore result = score();
  ASSERT_EQ(result.legs.size(), 1u);
  const LegScore& leg = result.legs[0];
  EXPECT_EQ(leg.from + leg.to + leg.axis, "n00n10x");
  EXPECT_EQ(leg.samples, 200);
  EXPECT_NEAR(leg.whole.rmse_m, 0.03, 1e-12);
  EXPECT_NEAR(leg.whole.max_m, 0.03, 1e-12);
  EXPECT_NEAR(leg.whole.mae_m, 0.03, 1e-12);
  EXPECT_NEAR(leg.whole.mean_m, 0.03, 1e-12);
  EXPECT_NEAR(leg.whole.std_m, 0.0, 1e-8);
  EXPECT_NEAR(result.all.rmse_m, 0.03, 1e-12);
}

TEST_F(TrackScoreTest, OfAllLegsHasTheSamplesInTheirBins) {
  flight_.fly(
      1, 10.0, [](double t_s) { return t_s < 0.4   ? -0.12
                                       : t_s < 6.0 ? 0.03
                                                   : 0.01; }, 0);
  const TrackScore result = score();
  EXPECT_NEAR(result.p95_m, 0.03, 1e-12);
  EXPECT_NEAR(result.settled_rmse_m, result.legs[0].settled_rmse_m, 1e-15);
  EXPECT_TRUE(std::isnan(result.turn_max_m));
  EXPECT_EQ(result.distribution[0], 960);
  EXPECT_EQ(result.distribution[2], 40);
}

TEST_F(TrackScoreTest, AnErrorBeyondTheLastBinIsInIt) {
  flight_.fly(
      1, 0.1, [](double) { return 1.5; }, 0);
  EXPECT_EQ(score().distribution.back(), 10);
}

TEST_F(TrackScoreTest, TheSignedDistributionKnowsLeftFromRight) {
  flight_.fly(
      1, 1.0, [](double t_s) { return t_s < 0.395   ? -0.012
                                      : t_s < 0.795 ? 0.003
                                                    : -7.0; }, 0);
  const SignedDistribution& bins = score().signed_distribution;
  EXPECT_EQ(bins[118], 40);  // −15 to −10 mm
  EXPECT_EQ(bins[121], 40);  // 0 to 5 mm
  EXPECT_EQ(bins.front(), 20);
}

TEST_F(TrackScoreTest, SamplesTellLegSideAndTurn) {
  flight_.add(Phase::align, 0, 0.6, 0.6, 0.0);
  flight_.fly(
      1, 0.1, [](double) { return -0.02; }, 0);
  flight_.add(Phase::turn, 0, 4.2, 0.6, radians(45.0));
  flight_.fly(2, 0.1, constant, 1);
  flight_.add(Phase::hover, 1, 4.2, 7.4, kPi / 2);
  const std::vector<TrackSample> samples = track_samples(flight_.record(), route_);
  ASSERT_EQ(samples.size(), 21u);
  EXPECT_NEAR(samples[0].signed_m, -0.02, 1e-12);
  EXPECT_EQ(samples[0].t, 2 * kTruthPeriod);
  EXPECT_TRUE(samples[10].turning);
  EXPECT_EQ(samples[10].leg, 0u);
  EXPECT_FALSE(samples[11].turning);
  EXPECT_EQ(samples[11].leg, 1u);
  EXPECT_EQ(samples[11].since_leg_began_s, 0.0);
}

TEST_F(TrackScoreTest, AnOffsetToTheRightHasANegativeMean) {
  flight_.fly(
      1, 2.0, [](double) { return -0.02; }, 0);
  EXPECT_NEAR(score().legs[0].whole.mean_m, -0.02, 1e-12);
  EXPECT_NEAR(score().legs[0].whole.mae_m, 0.02, 1e-12);
}

TEST_F(TrackScoreTest, ASineHasTheRootMeanSquareOfASine) {
  flight_.fly(
      1, 4.0, [](double t_s) { return 0.05 * std::sin(2.0 * kPi * t_s); }, 0);
  const OffsetStatistics s = score().legs[0].whole;
  EXPECT_NEAR(s.rmse_m, 0.05 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(s.std_m, 0.05 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(s.max_m, 0.05, 1e-9);
  EXPECT_NEAR(s.mean_m, 0.0, 1e-9);
  EXPECT_NEAR(s.mae_m, 0.05 * 2.0 / kPi, 1e-4);
}

TEST_F(TrackScoreTest, SettledIsLaterThanFiveSecondsAfterTheStart) {
  flight_.fly(
      1, 10.0, [](double t_s) { return t_s <= 5.0 + 1e-9 ? 0.3 : 0.01; }, 0);
  EXPECT_NEAR(score().legs[0].settled_rmse_m, 0.01, 1e-12);
  EXPECT_NEAR(score().legs[0].whole.max_m, 0.3, 1e-12);
  EXPECT_TRUE(std::isnan(score().legs[0].turn_max_m));
}

TEST_F(TrackScoreTest, ALegShorterThanFiveSecondsHasNoSettledPart) {
  flight_.fly(1, 5.0, constant, 0);
  EXPECT_TRUE(std::isnan(score().legs[0].settled_rmse_m));
}

TEST_F(TrackScoreTest, InATurnTheNearerEdgeCountsEachEndingAtTheNode) {
  flight_.fly(
      1, 1.0, [](double) { return 0.0; }, 0);
  flight_.add(Phase::turn, 0, 4.2 - 0.5, 0.6 + 0.02, radians(10.0));   // 0.02 off the first edge
  flight_.add(Phase::turn, 0, 4.2 + 0.03, 0.6 + 0.5, radians(60.0));   // 0.03 off the second
  flight_.add(Phase::turn, 0, 4.2 + 0.07, 0.6, radians(45.0));         // 0.07 past the node
  flight_.add(Phase::turn, 0, 4.2 + 0.03, 0.6 - 0.04, radians(45.0));  // 0.05 past both
  const LegScore leg = score().legs.at(0);
  EXPECT_EQ(leg.samples, 104);
  EXPECT_NEAR(leg.turn_max_m, 0.07, 1e-12);
  EXPECT_NEAR(leg.whole.mae_m * 104, 0.02 + 0.03 + 0.07 + 0.05, 1e-9);
}

TEST_F(TrackScoreTest, ACornerFlownWithoutAStopIsATurn) {
  flight_.add(Phase::follow, 0, 3.0, 0.6, 0.0);
  flight_.add(Phase::corner, 0, 4.2 + 0.02, 0.6 + 0.04, radians(45.0));  // 0.02 off the second edge
  EXPECT_NEAR(score().legs.at(0).turn_max_m, 0.02, 1e-12);
}

TEST_F(TrackScoreTest, ATurnIsNotSettledHoweverLate) {
  flight_.fly(
      1, 6.0, [](double) { return 0.01; }, 0);
  flight_.add(Phase::turn, 0, 4.2 + 0.2, 0.6, radians(45.0));
  EXPECT_NEAR(score().legs[0].settled_rmse_m, 0.01, 1e-12);
}

TEST_F(TrackScoreTest, DockingBeforeATurnCountsAsTheTurn) {
  flight_.fly(
      1, 6.0, [](double) { return 0.01; }, 0);
  flight_.add(Phase::dock, 0, 4.2 + 0.1, 0.6, 0.0);
  EXPECT_NEAR(score().legs[0].turn_max_m, 0.1, 1e-12);
}

TEST_F(TrackScoreTest, TheLegChangesWhenTheHeadingIsWithinThreeDegreesOfTheNextEdge) {
  flight_.fly(1, 1.0, constant, 0);
  flight_.add(Phase::turn, 0, 4.2, 0.6, radians(86.9));
  EXPECT_EQ(score().legs.size(), 1u);
  flight_.add(Phase::turn, 0, 4.2, 0.6, radians(87.1));
  ASSERT_EQ(score().legs.size(), 2u);
  EXPECT_EQ(score().legs[0].samples, 101);
  EXPECT_EQ(score().legs[1].samples, 1);
}

TEST_F(TrackScoreTest, AnOvershootOfTheTurnDoesNotGoBackToTheLegBefore) {
  flight_.fly(1, 1.0, constant, 0);
  for (const double heading_deg : {88.0, 94.0, 96.0, 94.0})
    flight_.add(Phase::turn, 0, 4.2, 0.6, radians(heading_deg));
  EXPECT_EQ(score().legs.at(1).samples, 4);
}

TEST_F(TrackScoreTest, TheFirstFiveSecondsAfterATurnBelongToItsLargestDeviation) {
  flight_.fly(
      1, 1.0, [](double) { return 0.0; }, 0);
  flight_.add(Phase::turn, 0, 4.2, 0.6, radians(88.0));
  flight_.fly(
      2, 10.0, [](double t_s) { return t_s < 4.9 ? 0.04 : 0.06; }, 1);
  EXPECT_NEAR(score().legs.at(1).turn_max_m, 0.06, 1e-12);  // 4.9 to 5 s
  EXPECT_NEAR(score().legs.at(1).settled_rmse_m, 0.06, 1e-12);
}

TEST_F(TrackScoreTest, ATurnThatEndsFurtherOffStillEndsTheLeg) {
  flight_.fly(
      1, 1.0, [](double) { return 0.0; }, 0);
  flight_.add(Phase::turn, 0, 4.2, 0.6, radians(85.0));
  for (int k = 0; k < 100; ++k) flight_.add(Phase::follow, 1, 4.2 + 0.02, 0.7 + 0.01 * k, radians(85.0));
  ASSERT_EQ(score().legs.size(), 2u);
  EXPECT_EQ(score().legs[0].samples, 101);
  EXPECT_NEAR(score().legs[1].whole.rmse_m, 0.02, 1e-12);
}

TEST_F(TrackScoreTest, HoverLandingAndGivingUpDoNotCount) {
  flight_.fly(1, 1.0, constant, 0);
  for (const Phase phase : {Phase::hover, Phase::land, Phase::aborted, Phase::finished})
    flight_.add(phase, 0, 2.0, 5.0, 0.0);
  EXPECT_EQ(score().legs[0].samples, 100);
  EXPECT_NEAR(score().legs[0].whole.max_m, 0.03, 1e-12);
}

TEST_F(TrackScoreTest, AllLegsTogetherAreWeighedBySamples) {
  flight_.fly(
      1, 3.0, [](double) { return 0.01; }, 0);
  flight_.add(Phase::turn, 0, 4.2 - 0.02, 0.7, radians(88.0));
  flight_.fly(
      2, 1.0, [](double) { return 0.02; }, 1);
  EXPECT_NEAR(score().all.rmse_m, std::sqrt((300 * 1e-4 + 101 * 4e-4) / 401.0), 1e-12);
  EXPECT_NEAR(score().all.max_m, 0.02, 1e-12);
}

TEST_F(TrackScoreTest, TheLastDockCountsUpToItsTarget) {
  flight_.fly(
      1, 1.0, [](double) { return 0.0; }, 0);
  flight_.add(Phase::turn, 0, 4.2, 0.6, radians(88.0));
  flight_.add(Phase::dock, 3, 4.2, 7.4 + 0.05, kPi / 2);
  EXPECT_NEAR(score().legs.at(1).whole.max_m, 0.05, 1e-8);
}

TEST_F(TrackScoreTest, RestIsTwoSecondsAndNotASampleLess) {
  hold(199, Phase::hover, 3, 0.0);
  EXPECT_FALSE(rest().has_value());
  hold(1, Phase::hover, 3, 0.0);
  ASSERT_TRUE(rest().has_value());
  EXPECT_NEAR(rest()->target_error_m, 0.01, 1e-12);
  EXPECT_NEAR(rest()->target_max_m, 0.01, 1e-12);
  EXPECT_NEAR(rest()->heading_rad, kPi / 2, 1e-12);
}

TEST_F(TrackScoreTest, RestIsBelowThreeCentimetresASecond) {
  hold(300, Phase::hover, 3, 0.03);
  EXPECT_FALSE(rest().has_value());
  hold(300, Phase::hover, 3, 0.0299);
  EXPECT_TRUE(rest().has_value());
}

TEST_F(TrackScoreTest, RestBeginsAnewAfterEveryFasterSample) {
  hold(150, Phase::hover, 3, 0.0);
  hold(1, Phase::hover, 3, 0.1);
  hold(199, Phase::hover, 3, 0.0);
  EXPECT_FALSE(rest().has_value());
}

TEST_F(TrackScoreTest, RestIsInTheLastDockOrInHover) {
  for (const Phase phase :
       {Phase::take_off, Phase::align, Phase::follow, Phase::turn, Phase::aborted, Phase::land})
    hold(300, phase, 3, 0.0);
  hold(300, Phase::dock, 0, 0.0);  // that of the turn
  EXPECT_FALSE(rest().has_value());
  hold(100, Phase::dock, 3, 0.0);
  hold(100, Phase::hover, 3, 0.0);
  EXPECT_TRUE(rest().has_value());
}

TEST_F(TrackScoreTest, RestTakesTheFirstTwoSecondsAndTheirMean) {
  hold(100, Phase::hover, 3, 0.0, 4.2, 7.42);
  hold(100, Phase::hover, 3, 0.0, 4.2, 7.46);
  hold(500, Phase::hover, 3, 0.0, 4.2, 7.90);
  ASSERT_TRUE(rest().has_value());
  EXPECT_NEAR(rest()->y_m, 7.44, 1e-9);
  EXPECT_NEAR(rest()->target_error_m, 0.04, 1e-9);
  EXPECT_NEAR(rest()->target_max_m, 0.06, 1e-9);
}

TEST_F(TrackScoreTest, RestAveragesHeadingsAcrossTheSeamOfTheCircle) {
  for (int k = 0; k < 200; ++k)
    flight_.add(Phase::hover, 3, 4.2, 7.4, (k % 2 == 0 ? 1 : -1) * radians(179.0), 0.0);
  ASSERT_TRUE(rest().has_value());
  EXPECT_NEAR(std::abs(rest()->heading_rad), kPi, 1e-9);
}

}  // namespace
}  // namespace lineservo::apps
