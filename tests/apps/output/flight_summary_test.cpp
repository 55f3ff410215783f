#include "apps/output/flight_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "apps/version.h"
#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;
using servo::Phase;
using ::testing::ElementsAre;
using testing::plan_on;
using testing::shipped_layout;

std::vector<std::string> keys(const ordered_json& json) {
  std::vector<std::string> list;
  for (const auto& item : json.items()) list.push_back(item.key());
  return list;
}

class FlightSummaryTest : public ::testing::Test {
 protected:
  FlightSummaryTest() {
    request_.instruction = "a03";
    request_.seed = 7;
  }
  FlightSummary summary() const { return summarise(request_, floor_, plan_, record_); }
  ordered_json json() const { return to_json(request_, summary()); }
  void add(int samples, Phase phase, int step, double x_m, double y_m, double speed_m_s = 0.0) {
    for (int k = 0; k < samples; ++k) {
      TruthSample s;
      s.t = kTruthPeriod * static_cast<long>(record_.truth.size());
      s.p_WB = {x_m, y_m, 0.5};
      s.v_W = {0.0, speed_m_s, 0.0};
      s.heading_rad = std::numbers::pi / 2;
      s.phase = phase;
      s.step = step;
      record_.truth.push_back(s);
    }
  }
  /// Follows column 0 with 0.02 m to the left and rests 0.03 m short of (x, y).
  void fly_to(double x_m, double y_m) {
    add(100, Phase::follow, 0, 0.58, 3.0, 0.1);
    add(200, Phase::hover, 2, x_m, y_m - 0.03);
  }

  FlightRequest request_;
  const vehicle::Layout floor_ = shipped_layout("warehouse");
  const servo::Plan plan_ = plan_on(floor_, "a03");
  FlightRecord record_;
};

TEST_F(FlightSummaryTest, HasEveryFieldInItsPlace) {
  fly_to(0.6, 7.4);
  const ordered_json j = json();
  EXPECT_THAT(keys(j),
              ElementsAre("instruction", "controller", "layout", "conditions", "seed", "speed_m_s", "version",
                          "outcome", "target", "arrival", "terminal_error_m", "terminal_max_m", "duration_s",
                          "distance_m", "legs", "tracking", "junctions", "timing", "trajectory_sha256"));
  EXPECT_THAT(keys(j["target"]), ElementsAre("node", "x_m", "y_m"));
  EXPECT_THAT(keys(j["arrival"]), ElementsAre("x_m", "y_m", "heading_rad"));
  ASSERT_EQ(j["legs"].size(), 1u);
  EXPECT_THAT(keys(j["legs"][0]), ElementsAre("from", "to", "axis", "rmse_m", "max_m", "mae_m", "std_m",
                                              "mean_m", "settled_rmse_m", "turn_max_m", "samples"));
  EXPECT_THAT(keys(j["tracking"]), ElementsAre("rmse_m", "max_m", "mae_m", "std_m", "mean_m"));
  EXPECT_THAT(keys(j["junctions"]),
              ElementsAre("frames", "misclassified", "accuracy", "held_accuracy", "smoothed_accuracy",
                          "ambiguous_share", "events", "events_right", "confusion"));
  EXPECT_THAT(keys(j["timing"]), ElementsAre("wall_s", "real_time_factor", "render_ms", "perception_ms",
                                             "control_ms", "physics_ms"));
}

TEST_F(FlightSummaryTest, SaysWhatWasAskedForAndWhatCameOfIt) {
  fly_to(0.6, 7.4);
  record_.timing.wall_s = 0.5;
  const ordered_json j = json();
  EXPECT_EQ(j["instruction"], "a03");
  EXPECT_EQ(j["controller"], "ibvs");
  EXPECT_EQ(j["layout"], "warehouse");
  EXPECT_EQ(j["conditions"], "paper");
  EXPECT_EQ(j["seed"], 7u);
  EXPECT_EQ(j["version"], std::string(kVersion));
  EXPECT_EQ(j["outcome"], "arrived");
  EXPECT_EQ(j["target"]["node"], "n03");
  EXPECT_NEAR(j["target"]["y_m"].get<double>(), 7.4, 1e-8);
  EXPECT_NEAR(j["arrival"]["y_m"].get<double>(), 7.37, 1e-9);
  EXPECT_NEAR(j["arrival"]["heading_rad"].get<double>(), std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(j["terminal_error_m"].get<double>(), 0.03, 1e-8);
  EXPECT_NEAR(j["terminal_max_m"].get<double>(), 0.03, 1e-8);
  EXPECT_NEAR(j["duration_s"].get<double>(), 2.99, 1e-9);
  EXPECT_NEAR(j["distance_m"].get<double>(), std::hypot(0.02, 4.37), 1e-9);
  EXPECT_EQ(j["legs"][0]["axis"], "y");
  EXPECT_NEAR(j["legs"][0]["rmse_m"].get<double>(), 0.02, 1e-9);
  EXPECT_NEAR(j["legs"][0]["mean_m"].get<double>(), 0.02,
              1e-9);  // column 0 is at x = 0.6: 0.58 is to the left
  EXPECT_EQ(j["legs"][0]["samples"], 100);
  EXPECT_NEAR(j["timing"]["real_time_factor"].get<double>(), 2.99 / 0.5, 1e-9);
  EXPECT_EQ(j["trajectory_sha256"].get<std::string>().size(), 64u);
  EXPECT_EQ(j["junctions"]["confusion"].size(), 10u);
  EXPECT_EQ(j["junctions"]["confusion"][9].size(), 10u);
  EXPECT_TRUE(summary().succeeded());
}

TEST_F(FlightSummaryTest, WhatDoesNotApplyIsNull) {
  add(1, Phase::take_off, 0, 0.6, 0.6);
  const ordered_json j = json();
  for (const char* key : {"x_m", "y_m", "heading_rad"}) EXPECT_TRUE(j["arrival"][key].is_null()) << key;
  EXPECT_TRUE(j["terminal_error_m"].is_null());
  EXPECT_TRUE(j["terminal_max_m"].is_null());
  EXPECT_TRUE(j["tracking"]["rmse_m"].is_null());
  EXPECT_TRUE(j["junctions"]["accuracy"].is_null());
  EXPECT_TRUE(j["junctions"]["ambiguous_share"].is_null());
  EXPECT_TRUE(j["legs"].is_array());
  EXPECT_TRUE(j["legs"].empty());
  EXPECT_EQ(j["junctions"]["frames"], 0);
}

TEST_F(FlightSummaryTest, ALegWithoutTurnOrSettledPartHasNullsThere) {
  fly_to(0.6, 7.4);
  EXPECT_TRUE(json()["legs"][0]["settled_rmse_m"].is_null());
  EXPECT_TRUE(json()["legs"][0]["turn_max_m"].is_null());
}

TEST_F(FlightSummaryTest, IsWrittenForAFlightThatNeverBegan) {
  const ordered_json j = ordered_json::parse(json().dump());
  EXPECT_EQ(j["outcome"], "timeout");
  EXPECT_EQ(j["duration_s"], 0.0);
  EXPECT_TRUE(j["timing"]["real_time_factor"].is_null());
}

TEST_F(FlightSummaryTest, ArrivedIsWithinThirtyCentimetresOfTheTarget) {
  fly_to(0.6, 7.4 + 0.03 + 0.299);
  EXPECT_EQ(summary().outcome, "arrived");
}

TEST_F(FlightSummaryTest, BeyondItIsNotArrived) {
  fly_to(0.6, 7.4 + 0.03 + 0.301);
  EXPECT_EQ(summary().outcome, "timeout");
  EXPECT_FALSE(summary().succeeded());
}

TEST_F(FlightSummaryTest, AtAnotherNodeItIsTheWrongOne) {
  fly_to(0.6, 5.133333333);
  EXPECT_EQ(summary().outcome, "wrong_node");
}

TEST_F(FlightSummaryTest, EveryEndHasItsOutcome) {
  fly_to(0.6, 7.4);
  const auto outcome = [this](auto change) {
    FlightRecord record = record_;
    change(record);
    return summarise(request_, floor_, plan_, record).outcome;
  };
  using servo::AbortReason;
  EXPECT_EQ(outcome([](FlightRecord& r) { r.crashed = true; }), "crashed");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.landed = true; }), "landed");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.out_of_time = true; }), "timeout");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.interrupted = true; }), "aborted");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.abort_reason = AbortReason::line_lost; }), "lost_line");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.abort_reason = AbortReason::node_overdue; }), "timeout");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.abort_reason = AbortReason::node_unexpected; }), "aborted");
  EXPECT_EQ(outcome([](FlightRecord& r) { r.crashed = r.out_of_time = true; }), "crashed");
}

}  // namespace
}  // namespace lineservo::apps
