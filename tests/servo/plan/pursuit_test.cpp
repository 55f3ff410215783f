#include "servo/plan/pursuit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/servo/test_floor.h"

namespace lineservo::servo {
namespace {

using testing::TestFloor;

/// Start, a bend, a corner and a disc at the end: pieces of 2, √2 and 1 m.
TestFloor track() {
  TestFloor floor("track");
  floor.add("start", {0.0, 0.0});
  floor.add("bend", {2.0, 0.0});
  floor.add("corner", {3.0, 1.0});
  floor.add("end", {3.0 - std::sqrt(0.5), 1.0 + std::sqrt(0.5)});
  floor.join("start", "bend");
  floor.join("bend", "corner");
  floor.join("corner", "end");
  floor.lay_disc("end");
  return floor;
}

std::optional<Plan> pursuit_on(const TestFloor& floor) {
  const Topology topology = floor.topology();
  return pursuit_of(compile(topology, floor.index("end"), "node:end"), topology);
}

TEST(Pursuit, IsOneStepToTheDiscWithTheWholeWay) {
  const std::optional<Plan> plan = pursuit_on(track());
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->steps.size(), 1u);
  const PlanStep& step = plan->steps[0];
  EXPECT_TRUE(step.pursued);
  EXPECT_EQ(step.manoeuvre, Manoeuvre::hover);
  EXPECT_EQ(step.expected.code, features::JunctionCode::start);
  EXPECT_EQ(step.node, "end");
  EXPECT_NEAR(step.edge_length_m, 2.0 + std::sqrt(2.0) + 1.0, 1e-12);
  EXPECT_EQ(plan->route.size(), 3u);
}

TEST(Pursuit, IsNotForAWayThatPassesABranch) {
  TestFloor branched("branched");
  branched.add("start", {0.0, 0.0});
  branched.add("tee", {2.0, 0.0});
  branched.add("side", {2.0, 1.0});
  branched.add("end", {4.0, 0.0});
  branched.join("start", "tee");
  branched.join("tee", "side");
  branched.join("tee", "end");
  branched.lay_disc("end");
  EXPECT_FALSE(pursuit_on(branched));
}

TEST(Pursuit, IsNotForAWayThatEndsWithoutADisc) {
  TestFloor floor("bare");
  floor.add("start", {0.0, 0.0});
  floor.add("end", {2.0, 0.0});
  floor.join("start", "end");
  EXPECT_FALSE(pursuit_on(floor));
}

}  // namespace
}  // namespace lineservo::servo
