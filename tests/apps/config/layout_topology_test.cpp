#include "apps/config/layout_topology.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::kPi;
using vehicle::Curve;

/// A ring of radius 2 m about the origin from p (2, 0), and a straight stub from p to q (5, 0).
vehicle::Layout ring_with_stub() {
  vehicle::Layout layout;
  layout.name = "ring";
  layout.nodes = {{"p", {2, 0}}, {"q", {5, 0}}};
  layout.edges.resize(2);
  layout.edges[0] = {0, 0, Curve::arc({2, 0}, {2, 0}, {0, 0}, true)};
  layout.edges[1] = {0, 1, Curve::line({2, 0}, {5, 0})};
  layout.labels = {{"d00", 1}};
  layout.start = 1;
  return layout;
}

/// A quarter of a circle to the left, from (0, 0) heading +x to (1, 1) heading +y.
vehicle::Layout quarter() {
  vehicle::Layout layout;
  layout.nodes = {{"p", {0, 0}}, {"q", {1, 1}}};
  layout.edges.resize(1);
  layout.edges[0] = {0, 1, Curve::arc({0, 0}, {1, 1}, {0, 1}, true)};
  return layout;
}

TEST(TopologyOf, KeepsNamesStartAndLabels) {
  const servo::Topology topology = topology_of(ring_with_stub());
  EXPECT_EQ(topology.name, "ring");
  ASSERT_EQ(topology.nodes.size(), 2u);
  EXPECT_EQ(topology.nodes[0].name, "p");
  EXPECT_EQ(topology.nodes[1].name, "q");
  EXPECT_EQ(topology.start, 1u);
  EXPECT_EQ(topology.labels.at("d00"), 1u);
}

TEST(TopologyOf, ALoopGivesItsNodeTwoArmsAndAStubOneAtEitherEnd) {
  const servo::Topology topology = topology_of(ring_with_stub());
  EXPECT_EQ(topology.nodes[0].arms.size(), 3u);
  EXPECT_EQ(topology.nodes[1].arms.size(), 1u);
  EXPECT_NEAR(topology.edges[0].length_m, 4.0 * kPi, 1e-12);
  EXPECT_DOUBLE_EQ(topology.edges[1].length_m, 3.0);
}

TEST(TopologyOf, ALoopLeavesAndArrivesInTheSameHeading) {
  const servo::Topology topology = topology_of(ring_with_stub());
  const auto& arms = topology.nodes[0].arms;
  EXPECT_NEAR(arms[0].heading_rad, kPi / 2, 1e-12);  // counter-clockwise
  EXPECT_NEAR(arms[0].arrival_heading_rad, kPi / 2, 1e-9);
  EXPECT_NEAR(arms[1].heading_rad, -kPi / 2, 1e-9);  // clockwise
  EXPECT_NEAR(arms[1].arrival_heading_rad, -kPi / 2, 1e-12);
}

TEST(TopologyOf, AnArcArrivesInAnotherHeadingThanItLeft) {
  const servo::Topology topology = topology_of(quarter());
  const servo::TopologyArm& out = topology.nodes[0].arms.at(0);
  const servo::TopologyArm& home = topology.nodes[1].arms.at(0);
  EXPECT_NEAR(out.heading_rad, 0.0, 1e-12);
  EXPECT_NEAR(out.arrival_heading_rad, kPi / 2, 1e-12);
  EXPECT_NEAR(home.heading_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(std::abs(home.arrival_heading_rad), kPi, 1e-12);
  EXPECT_NEAR(topology.edges[0].length_m, kPi / 2, 1e-12);
  EXPECT_EQ(home.to, 0u);
  EXPECT_EQ(out.to, 1u);
}

TEST(TopologyOf, ALineTurnsAtOnceByItsSharpestCorner) {
  vehicle::Layout layout = quarter();
  EXPECT_EQ(topology_of(layout).edges[0].sharpest_corner_rad, 0.0);
  layout.edges[0].centreline = Curve::polyline({{0, 0}, {1, 0}, {1, 0.5}, {1.5, 1}, {1, 1}});
  EXPECT_NEAR(topology_of(layout).edges[0].sharpest_corner_rad, 0.75 * kPi, 1e-12);
}

TEST(TopologyOf, ARedDiscOnANodeIsKnown) {
  vehicle::Layout layout = quarter();
  layout.start_markers = {{{0, 0}, 0.18, {40, 40, 220}}};
  layout.end_markers = {{{1, 1}, 0.1, {220, 40, 40}}};  // blue: no camera takes it for the marker
  EXPECT_TRUE(topology_of(layout).nodes[0].has_disc);
  EXPECT_FALSE(topology_of(layout).nodes[1].has_disc);
  layout.end_markers[0].colour = {40, 40, 220};
  EXPECT_TRUE(topology_of(layout).nodes[1].has_disc);
  layout.end_markers[0].radius_m = 0.01;  // too small to read J0
  EXPECT_FALSE(topology_of(layout).nodes[1].has_disc);
}

TEST(TopologyOf, HeadingsAreWrapped) {
  for (const vehicle::Layout& layout : {ring_with_stub(), quarter()}) {
    for (const servo::TopologyNode& node : topology_of(layout).nodes) {
      for (const servo::TopologyArm& arm : node.arms) {
        EXPECT_LE(std::abs(arm.heading_rad), kPi) << node.name;
        EXPECT_LE(std::abs(arm.arrival_heading_rad), kPi) << node.name;
      }
    }
  }
}

}  // namespace
}  // namespace lineservo::apps
