// Every fault of `evaluate faults`, flown: it ends in hover or on the ground, near to paint, and says why.

#include <gtest/gtest.h>

#include "apps/evaluate/fault_report.h"
#include "tests/apps/flight/test_flight.h"

namespace lineservo::apps {
namespace {

using testing::Flown;

class Fault : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Fault, EndsSafelyAndSaysWhy) {
  FaultStudyOptions options;
  options.faults = {fault_cases()[GetParam()].name};
  options.instructions = {"a13", "b02"};
  options.overrides = {"speed_m_s=0.3", "time_limit_s=200"};
  options.runs = 2;
  options.seed = 9501;
  const auto rows = study_faults(options, 1, [](std::size_t, std::size_t) { return true; });
  ASSERT_TRUE(rows.has_value());
  for (const FaultFlight& flight : rows->front().flights) {
    EXPECT_TRUE(flight.safety.is_safe())
        << flight.safety.ends << " " << flight.safety.paint_distance_m << " m: " << flight.command;
    EXPECT_EQ(flight.safety.reason.empty(), flight.safety.ends == "hover");  // where it believes the target
  }
}
INSTANTIATE_TEST_SUITE_P(All, Fault, ::testing::Range(std::size_t{0}, fault_cases().size()));

Flown fly_with(const std::vector<std::string>& settings) {
  FlightRequest request = testing::request_for("a13", "paper", 9501);
  apply_override(request, "speed_m_s=0.3");
  for (const std::string& setting : settings) apply_override(request, setting);
  return testing::fly(request);
}

bool tells(const Flown& flown, const std::string& kind) {
  return std::any_of(flown.record.events.begin(), flown.record.events.end(),
                     [&kind](const EventRecord& event) { return event.kind == kind; });
}

TEST(FaultsInFlight, ASecondOfDarknessCostsNothingButTime) {
  for (const char* fault : {"camera_black", "camera_frozen", "camera_silent"}) {
    const std::string key = std::string("faults.") + fault;
    const Flown flown = fly_with({key + ".start_s=8", key + ".duration_s=1"});
    EXPECT_EQ(flown.summary.outcome, "arrived") << fault << ": " << testing::story(flown);
    EXPECT_TRUE(tells(flown, "camera")) << fault;
  }
}

TEST(FaultsInFlight, LateAndDoubleFramesAreToldAndNotUsed) {
  for (const char* fault : {"frames_late", "frames_twice"}) {
    const std::string key = std::string("faults.") + fault;
    const Flown flown = fly_with({key + ".start_s=5", key + ".duration_s=1000"});
    EXPECT_EQ(flown.summary.outcome, "arrived") << fault << ": " << testing::story(flown);
    EXPECT_TRUE(tells(flown, "camera")) << fault;
    for (std::size_t i = 1; i < flown.record.ticks.size(); ++i)
      ASSERT_GT(flown.record.ticks[i].captured, flown.record.ticks[i - 1].captured);
  }
}

TEST(FaultsInFlight, TheBatterysTimeIsKept) {
  const Flown flown = fly_with({"executive.endurance_s=30"});
  EXPECT_EQ(flown.summary.outcome, "timeout") << testing::story(flown);
  EXPECT_TRUE(flown.record.landed);
  EXPECT_LT(flown.summary.duration_s, 30.0);
}

}  // namespace
}  // namespace lineservo::apps
