// What the executive makes of floors, frames and nodes that are not as planned.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/servo/executive/mission_checks.h"

namespace lineservo::servo {
namespace {

using features::FrameFeatures;
using testing::distance_m;
using testing::expect_arrival;
using testing::expect_smooth;
using testing::Logbook;
using testing::Mission;
using testing::mission_to;
using testing::MissionTick;
using testing::Pose;
using testing::TestFloor;

/// A mission that has to be broken off: hover, then land.
void expect_aborted(const Logbook& log, AbortReason reason) {
  EXPECT_EQ(log.reason, reason) << name(log.reason);
  EXPECT_EQ(log.end, Phase::finished);
  EXPECT_EQ(log.pose.height_m, 0.0);
  ASSERT_GE(log.phases.size(), 3u);
  EXPECT_THAT(log.phases, ::testing::Contains("aborted: " + std::string(name(reason))));
  EXPECT_EQ(log.phases[log.phases.size() - 2], "land");
  expect_smooth(log);
}

TEST(MissionTrouble, AMissedNodeIsMadeUpForByTheCodesThatFollow) {
  const TestFloor planned = testing::warehouse_floor();
  Mission mission = mission_to(planned, "a13");
  mission.floor.erase("a10", "a11");  // where the turn should be there is plain line
  const Logbook log = fly(mission);
  expect_arrival(log, planned.at("a13"), 0.01);
  EXPECT_THAT(log.nodes, ::testing::Contains("J9: turn at a20"));
}

TEST(MissionTrouble, ACodeThatDoesNotComeAtAllAborts) {
  const TestFloor planned = testing::warehouse_floor();
  Mission mission = mission_to(planned, "a13");
  for (const auto& [from, to] : {std::pair{"a10", "a11"}, {"a20", "a21"}, {"a30", "a31"}, {"a40", "a41"}})
    mission.floor.erase(from, to);
  const Logbook log = fly(mission);
  expect_aborted(log, AbortReason::node_overdue);
  EXPECT_GT(log.pose.p_W.x(),
            planned.at("a10").x() + 0.2 * 3.6);  // not before the length's tolerance is used up
  EXPECT_LT(log.pose.p_W.x(), planned.at("a40").x() - 1.0);
}

TEST(MissionTrouble, AnotherCodeThanExpectedIsHeldAgainstThoseBeforeAndAfter) {
  Mission mission = mission_to(testing::warehouse_floor(), "a53");
  mission.floor.add("extra", {0.6 + 7.2, -1.4});
  mission.floor.join("a20", "extra");  // a cross where the plan has a T
  expect_arrival(fly(mission), mission.floor.at("a53"), 0.01);
}

TEST(MissionTrouble, ANodeTooEarlyIsNone) {
  Mission mission = mission_to(testing::warehouse_floor(), "a13");
  mission.floor.add("middle", {1.8, 0.6});
  mission.floor.add("up", {1.8, 2.0});
  mission.floor.erase("a00", "a10");
  mission.floor.join("a00", "middle");
  mission.floor.join("middle", "a10");
  mission.floor.join("middle", "up");  // the right code, at a third of the way
  expect_arrival(fly(mission), mission.floor.at("a13"), 0.01);
}

TEST(MissionTrouble, ALineThatIsGoneAborts) {
  Mission mission = mission_to(testing::warehouse_floor(), "a13");
  mission.spoil = [](double, const Pose& pose, FrameFeatures& frame) {
    if (pose.p_W.x() > 2.0) frame = {};
  };
  const Logbook log = fly(mission);
  expect_aborted(log, AbortReason::line_lost);
  EXPECT_LT(log.pose.p_W.x(), 2.0 + 0.3 * 1.1);  // coasts for half a second at 0.3 m/s, no further
}

TEST(MissionTrouble, ALineLostForAMomentIsNoAbort) {
  const TestFloor floor = testing::warehouse_floor();
  Mission mission = mission_to(floor, "a13");
  mission.spoil = [](double, const Pose& pose, FrameFeatures& frame) {
    if (pose.p_W.x() > 2.0 && pose.p_W.x() < 2.09) frame = {};  // 0.3 s
  };
  expect_arrival(fly(mission), floor.at("a13"), 0.005);
}

TEST(MissionTrouble, WithoutALineItNeverLeavesTheStart) {
  Mission mission = mission_to(testing::warehouse_floor(), "a13");
  mission.spoil = [](double, const Pose&, FrameFeatures& frame) { frame = {}; };
  const Logbook log = fly(mission);
  expect_aborted(log, AbortReason::line_lost);
  EXPECT_LT(distance_m(log, mission.start.p_W), 1e-9);
}

TEST(MissionTrouble, ANodeThatIsLostWhileDockingAborts) {
  Mission mission = mission_to(testing::warehouse_floor(), "a13");
  mission.spoil = [](double, const Pose& pose, FrameFeatures& frame) {
    if (pose.p_W.x() > 4.12) frame = {};
  };
  const Logbook log = fly(mission);
  EXPECT_NE(log.reason, AbortReason::none);
  EXPECT_EQ(log.pose.height_m, 0.0);
}

TEST(MissionTrouble, WorkWithoutFiniteFeaturesIsNeverPassedOn) {
  // Frames full of NaN now and then, in every phase: all commands are finite, and the mission arrives.
  const TestFloor floor = testing::warehouse_floor();
  for (const char* controller : {"ibvs", "pid"}) {
    SCOPED_TRACE(controller);
    Mission mission = mission_to(floor, "a13");
    mission.controller = controller;
    if (mission.controller == "pid")
      mission.start = {floor.at("a00"), 0.0, 0.0}, mission.options.speed_m_s = 0.1;
    int frames = 0;
    mission.spoil = [&](double, const Pose&, FrameFeatures& frame) {
      constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
      if (++frames % 7 != 0) return;
      for (features::LineFeature& line : frame.lines) line.rho = line.theta_rad = kNaN;
      if (frame.junction) frame.junction->centre = {kNaN, kNaN};
      if (frame.centroid_px) frame.centroid_px->x = kNaN;
    };
    const Logbook log = fly(mission);
    for (const MissionTick& tick : log.ticks) ASSERT_TRUE(is_finite(tick.command)) << tick.t_s;
    EXPECT_EQ(log.end, Phase::finished);
    EXPECT_EQ(log.reason, AbortReason::none) << name(log.reason);
    EXPECT_LT(distance_m(log, floor.at("a13")), 0.25);
  }
}

}  // namespace
}  // namespace lineservo::servo
