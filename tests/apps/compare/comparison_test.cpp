#include "apps/compare/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/compare/metrics.h"
#include "tests/apps/compare/short_study.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;
using testing::complaint;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ShortStudy;

/// All but the processor times.
ordered_json untimed(const ComparisonResult& result) {
  ordered_json json = comparison_json(result);
  for (ordered_json& row : json["controllers"]) {
    row.erase("perception_ms");
    row.erase("control_ms");
  }
  return json;
}

std::vector<std::string> labels(const ComparisonOptions& options) {
  std::vector<std::string> list;
  for (const Entry& e : entries_of(options)) list.push_back(e.label());
  return list;
}

TEST(Comparison, IsTheSameToTheLastDigitForAnyNumberOfJobs) {
  const ShortStudy study;
  const ordered_json one = untimed(study.fly(1)), two = untimed(study.fly(2)), five = untimed(study.fly(5));
  EXPECT_EQ(one.dump(), two.dump());
  EXPECT_EQ(one.dump(), five.dump());
  EXPECT_EQ(one["flights"].size(), 4u);
}

TEST(Comparison, FliesEachInstructionOnTheFloorOfItsZone) {
  Block block;
  block.controllers = {"ibvs"};
  block.instructions = {"a13", "b01", "c03", "d00", "a03"};
  ComparisonOptions options;
  options.blocks = on_floors_of_zones(block);
  options.tuning = Tuning::published;
  std::vector<std::string> floors;
  for (const Entry& e : entries_of(options)) floors.push_back(e.layout);
  EXPECT_THAT(floors, ElementsAre("warehouse", "square", "octagon", "circle"));
  EXPECT_THAT(options.blocks[0].instructions, ElementsAre("a13", "a03"));
  EXPECT_NO_THROW(Comparison{options}) << "every target is on its floor";
}

TEST(Comparison, EveryControllerSeesTheSameFlights) {
  ShortStudy study;
  study.options.seed = 7;
  const ComparisonResult result = study.fly(2);
  ASSERT_EQ(result.contestants.size(), 2u);
  for (const Contestant& c : result.contestants) {
    ASSERT_EQ(c.flights.size(), 2u);
    EXPECT_EQ(c.flights[0].seed, 7u);
    EXPECT_EQ(c.flights[1].seed, 8u);
    EXPECT_EQ(c.flights[0].instruction, "node:q");
  }
}

TEST(Comparison, AFlightIsThatOfItsOwnCommand) {
  ShortStudy study;
  study.options.overrides = {"wind.mean_m_s=0.2"};
  const ComparisonResult result = study.fly(1);
  const Contestant& pid = result.contestants[0];
  FlightRequest request = pid.entry.request;
  request.instruction = "node:q";
  request.seed = 2;
  EXPECT_EQ(pid.flights[1].summary.trajectory_sha256,
            fly_mission(prepare(request)).summary.trajectory_sha256);
  EXPECT_THAT(pid.flights[1].command, HasSubstr("--seed 2 --set wind.mean_m_s=0.2"));
}

// As its command draws them, not on top of those that were drawn for the first seed.
TEST(Comparison, AFlightInDrawnConditionsIsThatOfItsOwnCommand) {
  ShortStudy study;
  study.options.conditions = "paper..harsh";
  study.options.seed = 5;
  const ComparisonResult result = study.fly(1);
  for (const auto& flight : result.contestants[0].flights) {
    FlightRequest request;
    request.seed = flight.seed;
    apply_conditions(request, "paper..harsh");
    request.controller = result.contestants[0].entry.controller;
    request.layout = result.contestants[0].entry.layout;
    request.instruction = "node:q";
    EXPECT_EQ(flight.summary.trajectory_sha256, fly_mission(prepare(request)).summary.trajectory_sha256)
        << flight.seed;
  }
}

TEST(Comparison, FailuresAreCountedAndNotDropped) {
  ShortStudy study;
  study.options.overrides = {"time_limit_s=5"};
  const ComparisonResult result = study.fly(2);
  for (const Contestant& c : result.contestants) {
    const Standing s = standing_of(c);
    EXPECT_EQ(s.arrived, 0);
    EXPECT_EQ(s.runs, 2);
    EXPECT_EQ(s.outcomes.at("timeout"), 2);
    EXPECT_TRUE(std::isnan(s.mean("terminal_error_m")));
  }
}

TEST(Comparison, BrokenOffHasNoResult) {
  const ShortStudy study;
  EXPECT_FALSE(Comparison(study.options).fly(2, [](std::size_t) { return false; }));
}

TEST(Comparison, RefusesATargetBeforeTheFirstFlight) {
  ShortStudy study;
  study.block().instructions = {"node:q", "node:x"};
  EXPECT_THROW(Comparison(study.options), InputError);
}

TEST(Comparison, RefusesASpeedThatIsNotAllowed) {
  ShortStudy study;
  study.block().speeds_m_s = {9.0};
  EXPECT_THAT(complaint([&] { Comparison c(study.options); }), HasSubstr("speed_m_s"));
}

TEST(Comparison, RefusesUnknownControllersAndReferencesThatDoNotFly) {
  ShortStudy study;
  study.options.reference = "lqr";
  EXPECT_THAT(complaint([&] { Comparison c(study.options); }), HasSubstr("--reference lqr"));
  study.block().controllers = {"lqr"};
  EXPECT_THROW(Comparison(study.options), std::invalid_argument);
}

TEST(EntriesOf, AreLayoutsThenSpeedsThenControllers) {
  ShortStudy study;
  study.block().speeds_m_s = {0.1, 0.2};
  const std::vector<Entry> entries = entries_of(study.options);
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_THAT(labels(study.options), ElementsAre("pid", "ibvs", "pid", "ibvs"));
  EXPECT_EQ(entries[1].speed_m_s, 0.1);
  EXPECT_EQ(entries[2].speed_m_s, 0.2);
  EXPECT_EQ(entries[0].group, entries[1].group);
  EXPECT_NE(entries[1].group, entries[2].group);
}

TEST(EntriesOf, OwnSpeedIsThatOfThePaperWhereThereIsOne) {
  ShortStudy study;
  study.block().own_speed = true;
  const std::vector<Entry> entries = entries_of(study.options);
  EXPECT_EQ(entries[0].speed_m_s, servo::find_controller("pid").published_speed_m_s);
  EXPECT_EQ(entries[1].speed_m_s, 0.3);  // of the conditions
  EXPECT_TRUE(entries[0].own_speed);
  EXPECT_EQ(entries[0].group, entries[1].group);
}

TEST(EntriesOf, VariantsAndOverridesReachTheSettingsInOrder) {
  ShortStudy study;
  study.block().controllers = {"pid"};
  study.block().overrides = {"servo.pid.kp=1", "servo.pid.ki=1"};
  study.block().variants = {{"kp=2", {"servo.pid.kp=2"}}};
  study.options.overrides = {"servo.pid.ki=3"};
  const std::vector<Entry> entries = entries_of(study.options);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].label(), "pid kp=2");
  EXPECT_EQ(entries[0].request.settings.laws.pid.kp, 2.0);
  EXPECT_EQ(entries[0].request.settings.laws.pid.ki, 3.0);
}

TEST(ReferenceOf, IsIbvsOrTheFirstThatFlies) {
  ShortStudy study;
  EXPECT_EQ(reference_of(study.options), "ibvs");
  study.block().controllers = {"pid"};
  EXPECT_EQ(reference_of(study.options), "pid");
  study.options.reference = "ibvs";
  EXPECT_EQ(reference_of(study.options), "ibvs");
}

}  // namespace
}  // namespace lineservo::apps
