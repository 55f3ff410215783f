// Single ticks of the executive, with laws that are made for the test. Whole flights are in mission_test.cpp.

#include "servo/executive/executive.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/servo/test_mission.h"

namespace lineservo::servo {
namespace {

using testing::Pose;
using testing::TestFloor;
using testing::TestVehicle;

/// Says always the same, and remembers what it was asked.
class FixedLaw final : public FollowLaw {
 public:
  explicit FixedLaw(const Command& command, FollowGoal* asked = nullptr) : command_(command), asked_(asked) {}
  void reset() override {}
  Command follow(const Observation&, const FollowGoal& goal) override {
    if (asked_) *asked_ = goal;
    return command_;
  }

 private:
  Command command_;
  FollowGoal* asked_;
};

/// A vehicle that hovers over a line of the warehouse while a law that does not dock says its word.
struct Bench {
  explicit Bench(const Command& command, double height_m = 0.5) : start(height_m) {
    options.limits.acceleration_m_s2 = 2.0;
    const Topology topology = floor.topology();
    executive = std::make_unique<Executive>(compile(topology, floor.index("a10"), "a10"),
                                            std::make_unique<FixedLaw>(command, &asked),
                                            LawTraits{false, true}, options);
  }
  Command tick() {
    const Pose pose{floor.at("a00") + Eigen::Vector2d(1.2, 0.0), 0.0, start};
    Observation o;
    o.now = o.captured = now;
    o.features = floor.view(pose);
    o.estimate.height_m = o.estimate.capture_height_m = start;
    now += std::chrono::milliseconds(100);
    return executive->tick(o, false);
  }
  void until(Phase phase) {
    for (int k = 0; k < 100 && executive->phase() != phase; ++k) tick();
    ASSERT_EQ(executive->phase(), phase);
  }

  TestFloor floor = testing::warehouse_floor();
  double start;
  ExecutiveOptions options;
  FollowGoal asked;
  std::unique_ptr<Executive> executive;
  Time now{0};
};

/// The yaw rate that reaches the vehicle of a law that says 0.2 rad/s, on an edge of 1 m, five degrees off.
double yaw_rate_on_an_edge(bool bends, const LawTraits& traits, FollowGoal* asked = nullptr) {
  Plan plan;
  plan.steps.push_back({});
  plan.steps.back().edge_length_m = 1.0;
  plan.steps.back().edge_bends = bends;
  Executive executive(plan, std::make_unique<FixedLaw>(VelocityCommand{0.1, 0.0, 0.0, 0.2}, asked), traits,
                      {});
  Command command;
  for (int k = 0; k < 60; ++k) {
    Observation o;
    o.now = o.captured = std::chrono::milliseconds(100 * k);
    features::LineFeature line;
    line.theta_rad = executive.phase() == Phase::follow ? 0.08 : 0.0;
    o.features.lines.push_back(line);
    o.features.code = {features::JunctionCode::straight, features::JunctionCode::straight,
                       features::JunctionCode::straight};
    o.estimate.height_m = o.estimate.capture_height_m = 0.5;
    command = executive.tick(o, false);
  }
  EXPECT_EQ(executive.phase(), Phase::follow);
  return std::get<VelocityCommand>(command).yaw_rate_rad_s;
}

TEST(Executive, HoldsTheHeadingForALawThatDoesNotAndTellsItSo) {
  FollowGoal asked;
  EXPECT_NEAR(yaw_rate_on_an_edge(false, {false, false}, &asked), -0.04, 1e-12);  // 0.5 / s · 0.08 rad
  EXPECT_NEAR(asked.yaw_rate_rad_s, -0.04, 1e-12);
  EXPECT_NEAR(yaw_rate_on_an_edge(false, {false, true}, &asked), 0.2, 1e-12);
  EXPECT_EQ(asked.yaw_rate_rad_s, 0.0);
}

TEST(Executive, OnABendTheYawOfALawCountsThatYawsThere) {
  EXPECT_NEAR(yaw_rate_on_an_edge(true, {false, false, false}), -0.04, 1e-12);
  EXPECT_NEAR(yaw_rate_on_an_edge(true, {false, false, true}), 0.2, 1e-12);
  EXPECT_NEAR(yaw_rate_on_an_edge(false, {false, false, true}), -0.04, 1e-12);
}

TEST(Executive, BeginsWithTheTakeOffAndClimbsWithinTheLimits) {
  Bench bench(VelocityCommand{}, 0.25);
  const auto first = std::get<VelocityCommand>(bench.tick());
  EXPECT_EQ(bench.executive->phase(), Phase::take_off);
  EXPECT_EQ(first.up_m_s, 0.0);  // no time has passed yet in which to change anything
  const auto second = std::get<VelocityCommand>(bench.tick());
  EXPECT_NEAR(second.up_m_s, 0.2, 1e-12);  // 2 m/s² for 0.1 s
  for (int k = 0; k < 5; ++k) bench.tick();
  EXPECT_NEAR(std::get<VelocityCommand>(bench.tick()).up_m_s, 1.5 * 0.25, 1e-12);
}

TEST(Executive, AsksTheLawForTheSpeedAndHeightOfItsOptions) {
  Bench bench(VelocityCommand{});
  bench.until(Phase::follow);
  bench.tick();
  EXPECT_EQ(bench.asked.speed_m_s, 0.1);
  EXPECT_EQ(bench.asked.height_m, 0.5);
}

TEST(Executive, WhatALawSaysThatIsNotFiniteBecomesRest) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const Command& bad :
       {Command(VelocityCommand{kNaN, 0, 0, 0}), Command(AttitudeCommand{0, kNaN, 0, 0.5})}) {
    Bench bench(bad);
    bench.until(Phase::follow);
    const Command command = bench.tick();
    ASSERT_TRUE(std::holds_alternative<VelocityCommand>(command));
    const auto& c = std::get<VelocityCommand>(command);
    EXPECT_EQ(c.forward_m_s, 0.0);
    EXPECT_EQ(c.left_m_s, 0.0);
    EXPECT_EQ(c.up_m_s, 0.0);
    EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
  }
}

TEST(Executive, AnAttitudeCommandPassesUnchanged) {
  Bench bench(AttitudeCommand{0.02, -0.03, 0.1, 0.5});
  bench.until(Phase::follow);
  const auto command = std::get<AttitudeCommand>(bench.tick());
  EXPECT_EQ(command.roll_rad, 0.02);
  EXPECT_EQ(command.pitch_rad, -0.03);
  EXPECT_EQ(command.yaw_rate_rad_s, 0.1);
  EXPECT_EQ(command.height_m, 0.5);
}

TEST(Executive, ALawThatAsksForTooMuchIsHeldByTheLimits) {
  Bench bench(VelocityCommand{30.0, 40.0, 0.0, 9.0});
  bench.until(Phase::follow);
  VelocityCommand c;
  for (int k = 0; k < 20; ++k) c = std::get<VelocityCommand>(bench.tick());
  EXPECT_NEAR(c.forward_m_s, 0.6 * 1.5, 1e-9);
  EXPECT_NEAR(c.left_m_s, 0.8 * 1.5, 1e-9);
  EXPECT_NEAR(c.yaw_rate_rad_s, 1.2, 1e-9);
}

TEST(Executive, EventsAreToldOnce) {
  Bench bench(VelocityCommand{});
  bench.until(Phase::follow);
  const auto events = bench.executive->take_events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, "phase");
  EXPECT_EQ(events[0].detail, "align");
  EXPECT_EQ(events[1].detail, "follow");
  EXPECT_TRUE(bench.executive->take_events().empty());
}

TEST(Executive, StandingStillForEverPassesNoNodeAndEnds) {
  Bench bench(VelocityCommand{});
  bench.until(Phase::follow);
  for (int k = 0; k < 300; ++k) bench.tick();
  EXPECT_EQ(bench.executive->step(), 0u);
  EXPECT_EQ(bench.executive->abort_reason(), AbortReason::stuck);
}

}  // namespace
}  // namespace lineservo::servo
