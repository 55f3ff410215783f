#include "apps/compare/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::apps {
namespace {

FlightSummary summary(const std::string& outcome, double rmse_m, double terminal_m) {
  FlightSummary s;
  s.outcome = outcome;
  s.rest = Rest{0, 0, 0, terminal_m, terminal_m};
  s.duration_s = 10.0;
  s.track.legs.resize(1);
  s.track.all = {rmse_m, 2.0 * rmse_m, 0.5 * rmse_m, 0.0, 0.0};
  s.track.distribution[1] = 5;
  s.junctions.frames = 10;
  s.junctions.misclassified = 1;
  s.timing.perception = {0.010, 10};
  return s;
}

Contestant contestant(const std::string& controller, bool tuned, std::vector<FlightSummary> flights) {
  Contestant c;
  c.entry.group = "g";
  c.entry.controller = controller;
  c.entry.tuned = tuned;
  for (FlightSummary& s : flights) c.flights.push_back({"a13", c.flights.size(), "", std::move(s)});
  return c;
}

const FlightSummary kGood = summary("arrived", 0.01, 0.02), kFair = summary("arrived", 0.03, 0.04),
                    kLost = summary("lost_line", 0.08, 0.5);

TEST(StandingOf, MeansAreOverTheFlightsThatHaveTheFigure) {
  const Standing s = standing_of(contestant("pid", false, {kGood, kFair, kLost}));
  EXPECT_EQ(s.runs, 3);
  EXPECT_EQ(s.arrived, 2);
  EXPECT_EQ(s.tracked, 3);
  EXPECT_EQ(s.outcomes.at("arrived"), 2);
  EXPECT_EQ(s.outcomes.at("lost_line"), 1);
  EXPECT_NEAR(s.mean("rmse_m"), 0.04, 1e-12);
  EXPECT_NEAR(s.mean("mean_m"), 0.02, 1e-12);
  EXPECT_NEAR(s.mean("terminal_error_m"), 0.03, 1e-12);  // of those that arrived
  EXPECT_NEAR(s.mean("duration_s"), 10.0, 1e-12);
  EXPECT_NEAR(s.max_m, 0.16, 1e-12);
  EXPECT_NEAR(s.mean("max_m"), 0.08, 1e-12);
  EXPECT_NEAR(s.junction_accuracy, 0.9, 1e-12);
  EXPECT_NEAR(s.perception_ms, 1.0, 1e-12);
  EXPECT_EQ(s.distribution[1], 15);
}

TEST(StandingOf, WithoutAnArrivalHasNoTerminalError) {
  const Standing s = standing_of(contestant("pid", false, {kLost}));
  EXPECT_TRUE(std::isnan(s.mean("terminal_error_m")));
  EXPECT_TRUE(std::isnan(s.mean("duration_s")));
  EXPECT_EQ(s.success_rate(), 0.0);
}

const Pair& pair_of(const std::vector<Pair>& pairs, const std::string& label, std::string_view metric) {
  for (const Pair& p : pairs)
    if (p.a->label() == label && p.metric == metric) return p;
  throw std::runtime_error("no such pair");
}

TEST(PairsOf, AreDifferencesFlightByFlightWhereBothHaveTheFigure) {
  const std::vector<Contestant> all = {contestant("ibvs", false, {kGood, kGood}),
                                       contestant("pid", false, {kFair, kLost})};
  const std::vector<Pair> pairs = pairs_of(all, "ibvs");
  EXPECT_EQ(pairs.size(), metrics().size());
  EXPECT_EQ(pair_of(pairs, "pid", "rmse_m").difference.pairs, 2u);
  EXPECT_NEAR(pair_of(pairs, "pid", "rmse_m").difference.mean, (0.02 + 0.07) / 2, 1e-12);
  EXPECT_EQ(pair_of(pairs, "pid", "terminal_error_m").difference.pairs, 1u);
  EXPECT_NEAR(pair_of(pairs, "pid", "terminal_error_m").difference.mean, 0.02, 1e-12);
  EXPECT_EQ(pair_of(pairs, "pid", "rmse_m").b->label(), "ibvs");
}

TEST(PairsOf, TunedStandsAgainstTunedWhereThereIsOne) {
  std::vector<Contestant> all = {contestant("ibvs", false, {kGood}), contestant("ibvs", true, {kGood}),
                                 contestant("pid", false, {kFair}), contestant("pid", true, {kFair})};
  std::vector<Pair> pairs = pairs_of(all, "ibvs");
  EXPECT_EQ(pairs.size(), 2 * metrics().size());  // the reference is not held against itself
  EXPECT_EQ(pair_of(pairs, "pid tuned", "rmse_m").b->label(), "ibvs tuned");
  EXPECT_EQ(pair_of(pairs, "pid", "rmse_m").b->label(), "ibvs");
  all.erase(all.begin() + 1);
  pairs = pairs_of(all, "ibvs");
  EXPECT_EQ(pair_of(pairs, "pid tuned", "rmse_m").b->label(), "ibvs");
}

TEST(PairsOf, GroupsAreNotMixed) {
  std::vector<Contestant> all = {contestant("ibvs", false, {kGood}), contestant("pid", false, {kFair})};
  all[1].entry.group = "other";
  EXPECT_TRUE(pairs_of(all, "ibvs").empty());
}

}  // namespace
}  // namespace lineservo::apps
