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

}  // namespace
}  // namespace lineservo::servo
