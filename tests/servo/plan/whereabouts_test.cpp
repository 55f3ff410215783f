#include "servo/plan/whereabouts.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"
#include "tests/servo/test_floor.h"

namespace lineservo::servo {
namespace {

using features::JunctionCode;

constexpr double kLeft_rad = 0.5 * features::kPi;
constexpr NodeSignature kTeeLeft{JunctionCode::corner_left, JunctionCode::tee_left};
constexpr NodeSignature kCross{JunctionCode::tee_ahead, JunctionCode::cross};

/// On the warehouse's first row, from a00 on.
Whereabouts on_first_row() {
  const auto floor = std::make_shared<const Topology>(testing::warehouse_floor().topology());
  const auto& arms = floor->nodes[floor->start].arms;
  for (std::size_t k = 0; k < arms.size(); ++k)
    if (std::abs(features::wrap_angle(arms[k].heading_rad)) < 0.1) return {floor, {floor->start, k}};
  return {};
}

std::string node_of(const Whereabouts& whereabouts) {
  const auto best = whereabouts.best();
  return best && best->on_node ? whereabouts.floor()->nodes[whereabouts.arm(best->arm).to].name : "none";
}

TEST(Whereabouts, KnowsNothingWithoutAFloor) {
  Whereabouts whereabouts;
  whereabouts.tell(kCross, {1.0, 1.0});
  whereabouts.leave(0.0);
  EXPECT_FALSE(whereabouts.best().has_value());
}

TEST(Whereabouts, FollowsTheCodesAndTheTurns) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  EXPECT_EQ(node_of(whereabouts), "a10");
  whereabouts.leave(kLeft_rad);
  whereabouts.tell(kCross, {2.2, 2.3});
  EXPECT_EQ(node_of(whereabouts), "a11");
  EXPECT_GT(whereabouts.best()->probability, 0.98);
}

TEST(Whereabouts, ANodeAtTwiceTheDistanceIsTheNextOne) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {7.1, 7.3});
  EXPECT_EQ(node_of(whereabouts), "a20");
  EXPECT_GT(whereabouts.best()->probability, 0.8);
}

TEST(Whereabouts, ANodeAtAThirdOfTheWayIsNone) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {1.1, 1.3});
  EXPECT_EQ(node_of(whereabouts), "none");
}

TEST(Whereabouts, AMisreadCodeIsStillTheNodeThatIsDue) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kCross, {3.5, 3.7});
  EXPECT_EQ(node_of(whereabouts), "a10");
}

// The turn at a10 was meant for column 1, and the first row's codes and distances follow.
TEST(Whereabouts, AWrongTurnShowsByTheCodesThatFollow) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  whereabouts.leave(kLeft_rad);
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  EXPECT_EQ(node_of(whereabouts), "a20");
  const double at_first = whereabouts.best()->probability;
  whereabouts.leave(0.0);
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  EXPECT_EQ(node_of(whereabouts), "a30");
  EXPECT_GT(whereabouts.best()->probability, at_first);
}

// A probability over all that it may be.
TEST(Whereabouts, IsAlwaysAProbability) {
  Whereabouts whereabouts = on_first_row();
  const NodeSignature told[] = {kTeeLeft, kCross, {JunctionCode::straight, JunctionCode::straight, true}};
  for (int k = 0; k < 60; ++k) {
    whereabouts.tell(told[k % 3], {0.4 * (k % 7), 0.5 * (k % 7) + 0.1});
    double on_nodes = 0.0;
    for (const TopologyNode& node : whereabouts.floor()->nodes) on_nodes += whereabouts.on_node(node.name);
    ASSERT_TRUE(whereabouts.best().has_value()) << k;
    EXPECT_LE(on_nodes, 1.0 + 1e-9);
    EXPECT_GT(whereabouts.best()->probability, 0.0);
    EXPECT_LE(whereabouts.best()->probability, 1.0 + 1e-9);
    whereabouts.leave(k % 2 == 0 ? 0.0 : kLeft_rad);
  }
}

TEST(Whereabouts, KnowsNoNodeOfAnotherName) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  EXPECT_EQ(whereabouts.on_node("nowhere"), 0.0);
  EXPECT_EQ(whereabouts.on_node(""), 0.0);
}

// Bayes by hand, but for other edges at the start: a node told right against a ghost.
TEST(Whereabouts, WeighsANodeAgainstAGhost) {
  const WhereaboutsOptions o;
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  EXPECT_NEAR(whereabouts.on_node("a10"), o.told_right / (o.told_right + o.ghost), 2e-3);
}

// The way adds up over ghosts: what was no node is still on the way to one.
TEST(Whereabouts, AGhostOnTheWayDoesNotShortenTheEdge) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {1.1, 1.3});
  ASSERT_EQ(node_of(whereabouts), "none");
  whereabouts.leave(0.0);
  whereabouts.tell(kTeeLeft, {2.3, 2.5});
  EXPECT_EQ(node_of(whereabouts), "a10");
}

TEST(Whereabouts, WayThatIsNotKnownTellsByTheCodeAlone) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {0.0, 1e6});
  EXPECT_EQ(node_of(whereabouts), "a10");
}

// Nothing is told while it is on a node: it has to leave it first.
TEST(Whereabouts, ATurnLeadsAlongTheArmThatItEndsOn) {
  Whereabouts whereabouts = on_first_row();
  whereabouts.tell(kTeeLeft, {3.5, 3.7});
  whereabouts.leave(kLeft_rad + 0.3);
  const auto best = whereabouts.best();
  ASSERT_TRUE(best.has_value());
  EXPECT_FALSE(best->on_node);
  EXPECT_EQ(whereabouts.floor()->nodes[whereabouts.arm(best->arm).to].name, "a11");
  EXPECT_EQ(whereabouts.on_node("a10"), 0.0);
}

}  // namespace
}  // namespace lineservo::servo
