#include "apps/scoring/target_score.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using servo::Phase;
using ::testing::ElementsAre;

/// A tour over a10 (step 0) and a11 (step 1) of the warehouse.
class TargetScoreTest : public ::testing::Test {
 protected:
  TargetScoreTest() {
    const servo::Topology topology = topology_of(floor_);
    servo::PlanBuilder builder(topology, "tour.yaml");
    builder.visit({servo::find_target(topology, "a10"), "a10", {}});
    builder.visit({servo::find_target(topology, "a11"), "a11", {}});
    plan_ = builder.plan();
  }
  void add(Phase phase, int step, const Eigen::Vector2d& p_W, int samples = 300) {
    for (int k = 0; k < samples; ++k) {
      TruthSample s;
      s.t = kTruthPeriod * static_cast<long>(record_.truth.size());
      s.p_WB << p_W, 0.5;
      s.phase = phase;
      s.step = step;
      record_.truth.push_back(s);
    }
  }
  std::vector<TargetScore> scores() const { return score_targets(record_, floor_, plan_); }
  std::vector<std::string> outcomes() const {
    std::vector<std::string> list;
    for (const TargetScore& score : scores()) list.push_back(score.outcome);
    list.push_back(flight_outcome(record_, scores()));
    return list;
  }

  const vehicle::Layout floor_ = testing::shipped_layout("warehouse");
  servo::Plan plan_;
  FlightRecord record_;
  const Eigen::Vector2d a10_W_{4.2, 0.6}, a11_W_{4.2, 2.866666667};
  const Eigen::Vector2d off_W_{0.03, 0.04};
};

TEST_F(TargetScoreTest, EachTargetHasItsOwnRest) {
  add(Phase::hover, 0, a10_W_ + off_W_);
  add(Phase::hover, 1, a11_W_);
  EXPECT_THAT(outcomes(), ElementsAre("arrived", "arrived", "arrived"));
  EXPECT_EQ(scores()[0].target, "a10");
  EXPECT_NEAR(scores()[0].rest->target_error_m, 0.05, 1e-9);
  EXPECT_NEAR(scores()[0].rest->until_s, 1.99, 1e-9);
  EXPECT_NEAR(scores()[1].rest->target_error_m, 0.0, 1e-6);
  EXPECT_NEAR(scores()[1].rest->until_s, 4.99, 1e-9);
}

TEST_F(TargetScoreTest, ALandingIsJudgedByWhereItEnded) {
  add(Phase::hover, 0, a10_W_);
  add(Phase::rest, 0, a10_W_ + off_W_);
  add(Phase::hover, 1, a11_W_);
  EXPECT_THAT(outcomes(), ElementsAre("landed", "arrived", "arrived"));
  EXPECT_NEAR((*scores()[0].landing_W - a10_W_).norm(), 0.05, 1e-9);
  record_.landed = true;
  EXPECT_THAT(outcomes(), ElementsAre("landed", "landed", "landed"));
}

TEST_F(TargetScoreTest, TheFirstTargetThatWasMissedDecides) {
  add(Phase::hover, 0, a11_W_);
  add(Phase::hover, 1, a11_W_);
  EXPECT_THAT(outcomes(), ElementsAre("wrong_node", "arrived", "wrong_node"));
}

TEST_F(TargetScoreTest, AFlightThatIsBrokenOffSaysOnTheWayToWhichTarget) {
  add(Phase::follow, 0, a10_W_);
  record_.abort_reason = servo::AbortReason::line_lost;
  EXPECT_THAT(outcomes(), ElementsAre("lost_line", "not_reached", "lost_line"));
  add(Phase::hover, 0, a10_W_);
  add(Phase::follow, 1, a11_W_);
  EXPECT_THAT(outcomes(), ElementsAre("arrived", "lost_line", "lost_line"));
}

TEST_F(TargetScoreTest, WithoutARestItIsATimeout) {
  add(Phase::hover, 0, a10_W_, 100);
  add(Phase::hover, 1, a11_W_);
  EXPECT_THAT(outcomes(), ElementsAre("timeout", "arrived", "timeout"));
}

}  // namespace
}  // namespace lineservo::apps
