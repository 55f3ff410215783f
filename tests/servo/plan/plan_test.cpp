#include "servo/plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/servo/test_floor.h"

namespace lineservo::servo {
namespace {

using features::Arms;
using features::degrees;
using features::JunctionCode;
using features::kPi;
using features::radians;
using features::wrap_angle;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TestFloor;

Plan plan_to(const TestFloor& floor, const std::string& target) {
  const Topology topology = floor.topology();
  return compile(topology, find_target(topology, target), target);
}

/// "J5 J9 turn 90 | J7 J3 go straight | …": preview, code ("!" when the line ends there) and manoeuvre.
std::string told(const Plan& plan) {
  std::string text;
  for (const PlanStep& step : plan.steps) {
    text += (text.empty() ? "" : " | ") + std::string(features::name(step.expected.preview)) + " " +
            std::string(features::name(step.expected.code)) + (step.expected.line_ends ? "! " : " ") +
            (step.expected.bend == Bend::none ? "" : std::string(name(step.expected.bend)) + " ") +
            std::string(name(step.manoeuvre));
    if (step.manoeuvre == Manoeuvre::turn) text += " " + std::to_string(std::lround(degrees(step.turn_rad)));
  }
  return text;
}

/// The message of a refusal, or nothing.
std::string refusal(const TestFloor& floor, const std::string& target) {
  try {
    plan_to(floor, target);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(Plan, A13TurnsAtTheFirstTeePassesTwoCrossesHoversOnTheThird) {
  const Plan plan = plan_to(testing::warehouse_floor(), "a13");
  EXPECT_NEAR(plan.start_heading_rad, 0.0, 1e-12);
  EXPECT_EQ(told(plan), "J5 J9 turn 90 | J7 J3 go straight | J7 J3 go straight | J7 J3 hover");
  EXPECT_EQ(plan.instruction, "a13");
  EXPECT_EQ(plan.target, "a13");
}

TEST(Plan, A53PassesFourTeesTurnsInTheCornerHoversOnTheThirdTee) {
  const Plan plan = plan_to(testing::warehouse_floor(), "a53");
  EXPECT_NEAR(plan.start_heading_rad, 0.0, 1e-12);
  EXPECT_EQ(
      told(plan),
      "J5 J9 go straight | J5 J9 go straight | J5 J9 go straight | J5 J9 go straight | J5 J5! turn 90 | "
      "J5 J9 go straight | J5 J9 go straight | J5 J9 hover");
}

TEST(Plan, A03GoesStraightUp) {
  const Plan plan = plan_to(testing::warehouse_floor(), "a03");
  EXPECT_NEAR(plan.start_heading_rad, kPi / 2, 1e-12);
  EXPECT_EQ(told(plan), "J4 J8 go straight | J4 J8 go straight | J4 J8 hover");
}

TEST(Plan, TheTopRowEndsInATeeAhead) {
  EXPECT_EQ(told(plan_to(testing::warehouse_floor(), "a14")),
            "J5 J9 turn 90 | J7 J3 go straight | J7 J3 go straight | J7 J3 go straight | J7 J7! hover");
}

TEST(Plan, ZoneBReadsLeftGoingRoundAndRightComingBack) {
  const TestFloor floor = testing::square_floor();
  EXPECT_EQ(told(plan_to(floor, "b01")), "J5 J5! turn 90 | J5 J9 hover");
  EXPECT_EQ(told(plan_to(floor, "b02")), "J5 J5! turn 90 | J5 J9 go straight | J5 J5! turn 90 | J5 J9 hover");
  EXPECT_EQ(told(plan_to(floor, "b03")), "J4 J4! turn -90 | J4 J8 hover");
  EXPECT_NEAR(std::abs(plan_to(floor, "b03").start_heading_rad), kPi, 1e-12);
}

TEST(Plan, EdgeLengthsAreThoseOfTheWay) {
  const Plan plan = plan_to(testing::warehouse_floor(), "a13");
  EXPECT_NEAR(plan.steps[0].edge_length_m, 3.6, 1e-12);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(plan.steps[k].edge_length_m, 6.8 / 3.0, 1e-12);
}

TEST(Plan, ANodeThatLooksLikePlainLineIsDrivenOver) {
  TestFloor floor("seam");
  floor.add("start", {0.0, 0.0});
  floor.add("seam", {2.0, 0.0});
  floor.add("end", {5.0, 0.0});
  floor.join("start", "seam");
  floor.join("seam", "end");
  const Plan plan = plan_to(floor, "node:end");
  EXPECT_EQ(told(plan), "J2 J2! hover");  // the dead end is told by the line's end
  EXPECT_NEAR(plan.steps[0].edge_length_m, 5.0, 1e-12);
}

/// Walks over the floor by the plan alone: no coordinates, no names, only arms, codes and manoeuvres.
class Walker {
 public:
  Walker(const Topology& topology, const Plan& plan) : topology_(topology), node_(topology.start) {
    take(plan.start_heading_rad);
    for (const PlanStep& step : plan.steps) {
      while (looks_plain()) take(arrival_rad_);
      EXPECT_EQ(look(), step.expected) << "at " << topology_.nodes[node_].name;
      if (step.manoeuvre != Manoeuvre::hover) take(arrival_rad_ + step.turn_rad);
    }
  }
  std::size_t node() const { return node_; }

 private:
  void take(double heading_rad) {
    for (const TopologyArm& arm : topology_.nodes[node_].arms) {
      if (std::abs(wrap_angle(arm.heading_rad - heading_rad)) > radians(25.0)) continue;
      node_ = arm.to;
      arrival_rad_ = arm.arrival_heading_rad;
      return;
    }
    FAIL() << "no arm at " << degrees(heading_rad) << " deg on " << topology_.nodes[node_].name;
  }
  NodeSignature look() const {
    Arms arms;
    for (const TopologyArm& arm : topology_.nodes[node_].arms) {
      const long quarter = std::lround(2.0 * wrap_angle(arm.heading_rad - arrival_rad_) / kPi);
      (quarter == 0   ? arms.forward
       : quarter == 1 ? arms.left
       : quarter < 0  ? (quarter == -1 ? arms.right : arms.back)
                      : arms.back) = true;
    }
    Arms ahead = arms;
    ahead.forward = false;
    return {code_of(ahead), code_of(arms), !arms.forward};
  }
  bool looks_plain() const { return look() == NodeSignature{}; }

  const Topology& topology_;
  std::size_t node_;
  double arrival_rad_ = 0.0;
};

TEST(Plan, EveryNodeOfTheGridIsReachedByItsPlan) {
  const TestFloor floor = testing::warehouse_floor();
  const Topology topology = floor.topology();
  for (const std::string& node : floor.names()) {
    if (node == "a00") continue;
    EXPECT_EQ(Walker(topology, plan_to(floor, node)).node(), floor.index(node)) << node;
    EXPECT_EQ(told(plan_to(floor, node)), told(plan_to(floor, "node:" + node)));
  }
}

TEST(Plan, EveryKeyLocationAndStubOfTheSquareIsReachedByItsPlan) {
  const TestFloor floor = testing::square_floor();
  const Topology topology = floor.topology();
  for (const std::string& node : floor.names()) {
    if (node == "b00") continue;
    EXPECT_EQ(Walker(topology, plan_to(floor, "node:" + node)).node(), floor.index(node)) << node;
  }
}

TEST(Plan, ZoneCTurnsWhereTheLineBends) {
  const TestFloor floor = testing::octagon_floor();
  EXPECT_EQ(told(plan_to(floor, "c01")), "J2 J2 bend left turn 45 | J5 J9 hover");
  EXPECT_EQ(told(plan_to(floor, "c06")),
            "J2 J2 bend right turn -45 | J4 J8 go straight | J2 J2 bend right turn -45 | J4 J8 hover");
}

/// Straight ahead for 2 m to a node, then on at these angles to the way, to n0, n1, …
TestFloor fork(const std::vector<double>& angles_deg) {
  TestFloor floor("fork");
  floor.add("start", {0.0, 0.0});
  floor.add("fork", {2.0, 0.0});
  floor.join("start", "fork");
  for (std::size_t k = 0; k < angles_deg.size(); ++k) {
    const std::string name = "n" + std::to_string(k);
    const double angle_rad = radians(angles_deg[k]);
    floor.add(name, {2.0 + 2.0 * std::cos(angle_rad), 2.0 * std::sin(angle_rad)});
    floor.join("fork", name);
  }
  return floor;
}

TEST(Plan, TwoArmsOnOneSideAreRefused) {
  for (const auto& angles_deg : {std::vector{0.0, 20.0}, {-12.0, 12.0}, {80.0, 100.0}, {0.0, 170.0}})
    EXPECT_THAT(refusal(fork(angles_deg), "node:n0"),
                AllOf(HasSubstr("node fork"), HasSubstr("cannot tell them apart"), HasSubstr("allowed")));
}

TEST(Plan, ArmsAskewMakeAForkThatIsToldByItsAngles) {
  EXPECT_EQ(told(plan_to(fork({0.0, 60.0}), "node:n1")), "J2 J2 fork turn 60 | J2 J2! hover");
  EXPECT_EQ(told(plan_to(fork({0.0, -45.0}), "node:n0")), "J2 J2 fork go straight | J2 J2! hover");
  EXPECT_EQ(told(plan_to(fork({135.0}), "node:n0")), "J2 J2 fork turn 135 | J2 J2! hover");
  EXPECT_EQ(told(plan_to(fork({20.0, -50.0}), "node:n0")), "J2 J2 fork turn 20 | J2 J2! hover");
  const NodeSignature y = signature({kPi, radians(45.0), radians(-45.0)});
  ASSERT_EQ(y.arms_rad.size(), 3u);
  EXPECT_NEAR(y.arms_rad[0], radians(-45.0), 1e-12);
  EXPECT_NEAR(y.arms_rad[2], kPi, 1e-12);
}

TEST(Plan, AForkWhoseLinesPartOutOfViewIsRefused) {
  Topology topology = fork({0.0, 45.0}).topology();
  EXPECT_NO_THROW(compile(topology, 2, "node:n0"));
  for (TopologyArm& arm : topology.nodes[1].arms) arm.width_m = 0.36;
  try {
    compile(topology, 2, "node:n0");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("node fork"), HasSubstr("0.36 m wide"), HasSubstr("fly higher")));
  }
  topology.view_m = 1.0;
  EXPECT_NO_THROW(compile(topology, 2, "node:n0"));
}

TEST(Plan, ArmsThatAreNearlyOneLineAreRefused) {
  EXPECT_THAT(refusal(fork({60.0, -101.0}), "node:n0"), AllOf(HasSubstr("node fork"), HasSubstr("19°")));
  EXPECT_EQ(refusal(fork({60.0, -110.0}), "node:n0"), "");
}

TEST(Plan, ABroadLineThatEndsBelowTheStartIsRefused) {
  Topology topology = fork({0.0, 90.0}).topology();
  topology.nodes[0].arms[0].width_m = 0.36;
  EXPECT_THROW(compile(topology, 1, "node:fork"), std::invalid_argument);
  topology.nodes[0].has_disc = true;
  EXPECT_NO_THROW(compile(topology, 1, "node:fork"));
}

TEST(Plan, TwoLinesThatLeaveTheStartSideBySideAreRefused) {
  TestFloor floor("start");
  floor.add("start", {0.0, 0.0});
  floor.add("a", {3.0, 0.0});
  floor.add("b", {3.0, 1.0});
  floor.join("start", "a");
  floor.join("start", "b");
  EXPECT_THAT(refusal(floor, "node:a"), AllOf(HasSubstr("node start"), HasSubstr("18° apart")));
  floor.move("b", {3.0, 3.0});
  EXPECT_EQ(refusal(floor, "node:a"), "");
}

TEST(Plan, AWayThatBendsIsStraightOnOrABendOrATurn) {
  for (const double angle_deg : {0.0, 10.0, -14.9}) EXPECT_EQ(refusal(fork({angle_deg}), "node:n0"), "");
  for (const double angle_deg : {15.1, 20.0, -24.9})
    EXPECT_THAT(refusal(fork({angle_deg}), "node:n0"), HasSubstr("node fork")) << angle_deg;
  EXPECT_THAT(refusal(fork({20.0}), "node:n0"), AllOf(HasSubstr("20°"), HasSubstr("15°"), HasSubstr("25°")));
  for (const double angle_deg : {26.0, -45.0, 64.0, 66.0, -90.0, 114.0})
    EXPECT_EQ(refusal(fork({angle_deg}), "node:n0"), "");
}

TEST(Plan, ALineThatTurnsSharplyBetweenNodesIsRefused) {
  Topology topology = fork({0.0, 90.0}).topology();
  topology.edges[1].sharpest_corner_rad = radians(14.0);
  EXPECT_NO_THROW(compile(topology, 2, "node:n0"));
  topology.edges[1].sharpest_corner_rad = radians(30.0);
  try {
    compile(topology, 2, "node:n0");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("from fork to n0"), HasSubstr("30°"), HasSubstr("put a node")));
  }
  EXPECT_NO_THROW(compile(topology, 1, "node:fork")) << "not on this way";
}

TEST(Plan, ANodeUnderADiscIsToldByIt) {
  TestFloor floor = fork({0.0});
  floor.lay_disc("n0");
  EXPECT_EQ(told(plan_to(floor, "node:n0")), "J0 J0 hover");
  floor.lay_disc("fork");
  EXPECT_EQ(told(plan_to(floor, "node:n0")), "J0 J0 go straight | J0 J0 hover");
}

TEST(Plan, TheStartItselfIsRefused) {
  EXPECT_THAT(refusal(testing::warehouse_floor(), "a00"), AllOf(HasSubstr("a00"), HasSubstr("take-off")));
}

TEST(Plan, AStartUnderADiscOnARingIsOneRound) {
  TestFloor ring("ring");
  ring.add("start", {0.0, 0.0});
  ring.add("se", {2.0, 0.0});
  ring.add("ne", {2.0, 2.0});
  ring.add("nw", {-2.0, 2.0});
  ring.add("sw", {-2.0, 0.0});
  for (const auto& [a, b] :
       {std::pair{"start", "se"}, {"se", "ne"}, {"ne", "nw"}, {"nw", "sw"}, {"sw", "start"}})
    ring.join(a, b);
  EXPECT_THAT(refusal(ring, "node:start"), HasSubstr("take-off"));
  ring.lay_disc("start");
  EXPECT_EQ(told(plan_to(ring, "node:start")),
            "J5 J5! turn 90 | J5 J5! turn 90 | J5 J5! turn 90 | J5 J5! turn 90 | J0 J0 hover");
}

/// A mission over targets by name; each stops as told.
Plan plan_over(const TestFloor& floor, const std::vector<std::string>& targets, const Stop& stop = {}) {
  const Topology topology = floor.topology();
  PlanBuilder builder(topology, "tour");
  for (const std::string& target : targets) builder.visit({find_target(topology, target), target, stop});
  return builder.plan();
}

TEST(Plan, EachLegOfAMissionLeavesWhereTheLastOneEnded) {
  const Plan plan = plan_over(testing::warehouse_floor(), {"a12", "a32", "a30"});
  EXPECT_EQ(told(plan),
            "J5 J9 turn 90 | J7 J3 go straight | J7 J3 hover | J7 J3 go straight | J7 J3 hover | "
            "J7 J3 go straight | J7 J7! hover");
  EXPECT_NEAR(plan.steps[2].turn_rad, -kPi / 2, 1e-12) << "onto row 2";
  EXPECT_NEAR(plan.steps[4].turn_rad, -kPi / 2, 1e-12) << "down column 3";
  EXPECT_EQ(plan.steps[2].target, "a12");
  EXPECT_EQ(plan.steps[3].target, "");
  EXPECT_EQ(plan.target, "a30");
  EXPECT_EQ(plan.instruction, "tour");
  EXPECT_EQ(plan.route.size(), 7u);
}

TEST(Plan, AMissionTurnsRoundWhereItMust) {
  const Plan plan = plan_over(testing::warehouse_floor(), {"a12", "a11"});
  EXPECT_NEAR(std::abs(plan.steps[2].turn_rad), kPi, 1e-12);
  EXPECT_EQ(plan.steps[3].node, "a11");
}

TEST(Plan, AMissionReturnsToTheDiscThatItStartedFrom) {
  TestFloor floor = testing::warehouse_floor();
  floor.lay_disc("a00");
  const Plan plan = plan_over(floor, {"a10", "a00"});
  EXPECT_EQ(told(plan), "J5 J9 hover | J0 J0 hover");
}

TEST(Plan, AMissionRefusesATargetWhereItStands) {
  try {
    plan_over(testing::warehouse_floor(), {"a12", "a12"});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("a12"), HasSubstr("where the target before is")));
  }
}

TEST(Plan, ARefusedTargetLeavesThePlanAsItWas) {
  const Topology topology = testing::warehouse_floor().topology();
  PlanBuilder builder(topology, "tour");
  builder.visit({find_target(topology, "a12"), "a12", {}});
  const std::size_t steps = builder.plan().steps.size();
  EXPECT_THROW(builder.visit({find_target(topology, "a12"), "a12", {}}), std::invalid_argument);
  EXPECT_EQ(builder.plan().steps.size(), steps);
  EXPECT_EQ(builder.plan().steps.back().turn_rad, 0.0);
}

TEST(Plan, ATargetWithoutAWayIsRefused) {
  TestFloor floor = testing::warehouse_floor();
  floor.add("island", {100.0, 100.0});
  EXPECT_THAT(refusal(floor, "node:island"), AllOf(HasSubstr("island"), HasSubstr("no painted way")));
}

TEST(Plan, ATargetOnPlainLineIsRefused) {
  TestFloor floor("seam");
  floor.add("start", {0.0, 0.0});
  floor.add("seam", {2.0, 0.0});
  floor.add("end", {5.0, 0.0});
  floor.join("start", "seam");
  floor.join("seam", "end");
  EXPECT_THAT(refusal(floor, "node:seam"), AllOf(HasSubstr("seam"), HasSubstr("plain line")));
}

TEST(Plan, UnknownTargetsAreAnsweredWithThoseThatThereAre) {
  const TestFloor floor = testing::square_floor();
  EXPECT_THAT(refusal(floor, "a13"),
              AllOf(HasSubstr("square"), HasSubstr("a13"), HasSubstr("b00 b01 b02 b03")));
  EXPECT_THAT(refusal(floor, "node:nowhere"), AllOf(HasSubstr("square"), HasSubstr("'nowhere'")));
  EXPECT_THAT(refusal(floor, "b9"), AllOf(HasSubstr("'b9'"), HasSubstr("allowed")));
  EXPECT_THAT(refusal(TestFloor("bare"), "a13"), HasSubstr("node:NAME"));
}

TEST(Plan, FindsTargetsByLabelAndByName) {
  const TestFloor floor = testing::warehouse_floor();
  const Topology topology = floor.topology();
  EXPECT_EQ(find_target(topology, "a13"), floor.index("a13"));
  EXPECT_EQ(find_target(topology, "a:1:3"), floor.index("a13"));
  EXPECT_EQ(find_target(topology, "node:a13"), floor.index("a13"));
}

}  // namespace
}  // namespace lineservo::servo
