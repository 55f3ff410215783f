#include "apps/compare/tuning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/tuned_settings.h"
#include "servo/law/controllers.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Not;

std::vector<std::string> keys(const std::string& controller) {
  std::vector<std::string> list;
  for (const TunableParameter& p : tunable_parameters(controller)) list.push_back(p.key);
  return list;
}

TEST(TunableParameters, AreTheGainsOfTheLawAndOfDockingForThoseThatDock) {
  EXPECT_THAT(keys("pid"),
              ::testing::ElementsAre("servo.pid.kp", "servo.pid.ki", "servo.pid.kd", "servo.pid.dead_zone"));
  EXPECT_THAT(keys("vtp"), ::testing::ElementsAre("servo.vtp.change_m_per_px", "servo.vtp.change_px",
                                                  "servo.vtp.period_s"));
  EXPECT_THAT(keys("ibvs"),
              AllOf(Contains("servo.ibvs.gain_at_zero"), Contains("servo.dock.gain_at_zero"),
                    Not(Contains("servo.ibvs.view_margin")), Not(Contains("servo.ibvs.drift_limit_m_s"))));
}

TEST(TunableParameters, EveryLawHasSomeWithinBoundsAboutThePublishedValue) {
  for (const servo::Controller& c : servo::controllers()) {
    const auto parameters = tunable_parameters(std::string(c.name));
    EXPECT_FALSE(parameters.empty()) << c.name;
    for (const TunableParameter& p : parameters) {
      EXPECT_GT(p.low, 0.0) << p.key;
      EXPECT_LE(p.low, p.published) << p.key;
      EXPECT_LE(p.published, p.high) << p.key;
      EXPECT_LE(p.high, 8.0 * p.published * (1 + 1e-12)) << p.key;
    }
  }
}

FlightSummary flown(const std::string& outcome, double rmse_m, double terminal_m, double tilt_rad_s) {
  FlightSummary s;
  s.outcome = outcome;
  s.rest = Rest{0, 0, 0, terminal_m, terminal_m};
  s.track.all.rmse_m = rmse_m;
  s.tilt_rate_rms_rad_s = tilt_rad_s;
  return s;
}

TEST(FlightCost, IsTheWeightedSumOrThePenalty) {
  EXPECT_DOUBLE_EQ(flight_cost(flown("arrived", 0.05, 0.10, 0.3)), 1.0 + 2.0 + 3.0);
  EXPECT_DOUBLE_EQ(flight_cost(flown("lost_line", 0.01, 0.01, 0.01)), 20.0);
}

TEST(TuningResult, TheBestIsTheFirstOfTheCheapest) {
  TuningResult result;
  result.trials = {{{1.0}, 3.0, 0}, {{2.0}, 1.0, 0}, {{3.0}, 1.0, 0}};
  EXPECT_EQ(result.best().values.front(), 2.0);
  EXPECT_EQ(result.published().values.front(), 1.0);
}

TEST(TunedYaml, ReadsBackAsTheBestValues) {
  const testing::TempFolder temp;
  TuningResult result;
  result.controller = "pid";
  result.parameters = {{"servo.pid.kp", 0.5, 0.1, 4.0}, {"servo.pid.kd", 0.25, 0.1, 2.0}};
  result.trials = {{{0.5, 0.25}, 3.0, 0}, {{0.7, 0.3333}, 1.0, 0}};
  FlightRequest request;
  request.controller = "pid";
  apply_tuned(request, temp.write("pid.yaml", tuned_yaml(result)));
  EXPECT_EQ(request.settings.laws.pid.kp, 0.7);
  EXPECT_EQ(request.settings.laws.pid.kd, 0.3333);
}

TEST(Tune, BrokenOffHasNoResult) {
  EXPECT_FALSE(tune("pid", {2, 2}, [](std::size_t) { return false; }));
}

TEST(Tune, TheFirstPointIsAsPublished) {
  const auto result = tune("pid", {1, 2}, [](std::size_t) { return true; });
  ASSERT_TRUE(result);
  ASSERT_EQ(result->trials.size(), 1u);
  for (std::size_t i = 0; i < result->parameters.size(); ++i)
    EXPECT_EQ(result->trials[0].values[i], result->parameters[i].published);
}

}  // namespace
}  // namespace lineservo::apps
