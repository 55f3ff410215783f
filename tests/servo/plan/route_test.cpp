#include "servo/plan/route.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/servo/test_floor.h"

namespace lineservo::servo {
namespace {

using testing::TestFloor;

/// The nodes passed, "a00 a10 …"; "none" without a route.
std::string nodes_on_route(const TestFloor& floor, std::string_view from, std::string_view to) {
  const Topology topology = floor.topology();
  const auto route = shortest_route(topology, floor.index(from), floor.index(to));
  if (!route) return "none";
  std::string nodes(from);
  for (const TopologyArm& arm : *route) nodes += " " + topology.nodes[arm.to].name;
  return nodes;
}

TEST(Route, ZoneAGoesAlongRowZeroThenUp) {
  const TestFloor floor = testing::warehouse_floor();
  EXPECT_EQ(nodes_on_route(floor, "a00", "a13"), "a00 a10 a11 a12 a13");
  EXPECT_EQ(nodes_on_route(floor, "a00", "a53"), "a00 a10 a20 a30 a40 a50 a51 a52 a53");
  EXPECT_EQ(nodes_on_route(floor, "a00", "a03"), "a00 a01 a02 a03");
  EXPECT_EQ(nodes_on_route(floor, "a00", "a30"), "a00 a10 a20 a30");
}

TEST(Route, EveryGridNodeIsReachedWithAtMostOneTurn) {
  const TestFloor floor = testing::warehouse_floor();
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) {
      if (i == 0 && j == 0) continue;
      std::string expected = "a00";
      for (int column = 1; column <= i; ++column) expected += " a" + std::to_string(column) + "0";
      for (int row = 1; row <= j; ++row) expected += " a" + std::to_string(i) + std::to_string(row);
      EXPECT_EQ(nodes_on_route(floor, "a00", "a" + std::to_string(i) + std::to_string(j)), expected);
    }
  }
}

TEST(Route, ZonesBAndCTakeTheShorterWayRound) {
  const TestFloor square = testing::square_floor(), octagon = testing::octagon_floor();
  EXPECT_EQ(nodes_on_route(square, "b00", "b01"), "b00 corner0 b01");
  EXPECT_EQ(nodes_on_route(square, "b00", "b03"), "b00 corner3 b03");
  EXPECT_EQ(nodes_on_route(octagon, "c00", "c02"), "c00 corner0 c01 corner1 c02");
  EXPECT_EQ(nodes_on_route(octagon, "c00", "c06"), "c00 corner7 c07 corner6 c06");
}

TEST(Route, TiesGoCounterClockwise) {
  EXPECT_EQ(nodes_on_route(testing::square_floor(), "b00", "b02"), "b00 corner0 b01 corner1 b02");
  EXPECT_EQ(nodes_on_route(testing::octagon_floor(), "c00", "c04"),
            "c00 corner0 c01 corner1 c02 corner2 c03 corner3 c04");
}

TEST(Route, LengthCountsBeforeTheFirstHeading) {
  // The far way leaves nearer to +x, which decides between equals only.
  TestFloor floor("two ways");
  floor.add("start", {0.0, 0.0});
  floor.add("bend", {-1.0, 2.0});
  floor.add("target", {0.0, 4.0});
  floor.add("far", {9.0, 2.0});
  floor.join("start", "far");
  floor.join("far", "target");
  floor.join("start", "bend");
  floor.join("bend", "target");
  EXPECT_EQ(nodes_on_route(floor, "start", "target"), "start bend target");
}

TEST(Route, AWornEdgeIsGoneAround) {
  TestFloor floor = testing::warehouse_floor();
  floor.erase("a11", "a12");
  EXPECT_EQ(nodes_on_route(floor, "a00", "a13"), "a00 a01 a02 a03 a13");  // as long, one turn as well
  floor.erase("a02", "a03");
  EXPECT_EQ(nodes_on_route(floor, "a00", "a13"), "a00 a01 a02 a12 a13");  // fewer turns are not to be had
}

TEST(Route, NeverTurnsBackOnAnEdge) {
  // A dead end: the way out of the stub would be the way in.
  TestFloor floor("stub");
  floor.add("start", {0.0, 0.0});
  floor.add("end", {1.0, 0.0});
  floor.add("behind", {-1.0, 0.0});
  floor.join("start", "end");
  EXPECT_EQ(nodes_on_route(floor, "start", "end"), "start end");
  EXPECT_EQ(nodes_on_route(floor, "start", "behind"), "none");
}

TEST(Route, FromANodeToItselfIsTheShortestRound) {
  EXPECT_EQ(nodes_on_route(testing::square_floor(), "b00", "b00"),
            "b00 corner0 b01 corner1 b02 corner2 b03 corner3 b00");
  EXPECT_EQ(nodes_on_route(testing::warehouse_floor(), "a00", "a00"), "a00 a10 a11 a01 a00");
}

}  // namespace
}  // namespace lineservo::servo
