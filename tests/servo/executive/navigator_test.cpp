#include "servo/executive/navigator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/servo/executive/mission_checks.h"
#include "tests/servo/test_floor.h"

namespace lineservo::servo {
namespace {

using features::JunctionCode;
using Verdict = Navigator::Verdict;

constexpr NodeSighting kTeeLeft{JunctionCode::tee_left};
constexpr NodeSighting kCross{JunctionCode::cross};
constexpr NodeSighting kDeadEnd{JunctionCode::straight, true};
constexpr NodeSighting kCornerLeft{JunctionCode::corner_left, true};

Navigator navigator_to(const std::string& target) {
  const testing::TestFloor floor = testing::warehouse_floor();
  const auto topology = std::make_shared<const Topology>(floor.topology());
  Plan plan = compile(*topology, find_target(*topology, target), target);
  plan.floor = topology;
  return Navigator(plan);
}

/// About as far as an edge of this length.
Whereabouts::Way way(double length_m) {
  return {0.97 * length_m, 1.03 * length_m};
}
constexpr double kColumns_m = 3.6, kRows_m = 6.8 / 3.0;

TEST(Navigator, NodesAsPlannedAreTakenOneByOne) {
  Navigator navigator = navigator_to("a13");
  ASSERT_EQ(navigator.plan().steps.size(), 4u);
  EXPECT_EQ(navigator.judge(kTeeLeft, way(kColumns_m), true), Verdict::as_planned);
  EXPECT_EQ(navigator.step()->manoeuvre, Manoeuvre::turn);
  EXPECT_THAT(navigator.place(), ::testing::HasSubstr("at a10 by the codes"));
  navigator.advance();
  for (std::size_t k = 1; k < 4; ++k) {
    EXPECT_EQ(navigator.index(), k);
    EXPECT_EQ(navigator.judge(kCross, way(kRows_m), true), Verdict::as_planned) << k;
    navigator.advance();
  }
  EXPECT_EQ(navigator.step(), nullptr) << "past the plan's end nothing is expected";
}

TEST(Navigator, ANodeThatCannotHaveComeYetIsPassedBy) {
  Navigator navigator = navigator_to("a13");
  EXPECT_EQ(navigator.judge(kTeeLeft, way(0.3 * kColumns_m), false), Verdict::ignored);
  EXPECT_EQ(navigator.index(), 0u);
  EXPECT_EQ(navigator.judge(kTeeLeft, way(0.7 * kColumns_m), true), Verdict::as_planned) << "the whole way";
}

// A line that ends is worn paint, for all that is known, where the plan does not end it.
TEST(Navigator, ADeadEndThatIsNotPlannedIsIgnored) {
  Navigator navigator = navigator_to("a13");
  EXPECT_EQ(navigator.judge(kDeadEnd, way(kColumns_m), true), Verdict::ignored);
  EXPECT_EQ(navigator.judge(kTeeLeft, way(kColumns_m), true), Verdict::as_planned);
}

// a10 was missed: at a20 the way back to column 1 is another plan, with the same target.
TEST(Navigator, PlansAnewFromWhereTheCodesSayItIs) {
  Navigator navigator = navigator_to("a13");
  EXPECT_EQ(navigator.judge(kTeeLeft, way(2.0 * kColumns_m), false), Verdict::planned_anew);
  EXPECT_EQ(navigator.index(), 0u);
  EXPECT_EQ(navigator.plan().target, "a13");
  EXPECT_EQ(navigator.step()->node, "a20") << "the node that was told is the new plan's first";
  EXPECT_EQ(navigator.plan().steps.back().manoeuvre, Manoeuvre::hover);
  EXPECT_EQ(navigator.plan().steps.back().node, "a13");
}

TEST(Navigator, WithoutAFloorAPlanIsTakenAsItIs) {
  Plan plan = testing::plan_to(testing::warehouse_floor(), "a13");
  plan.floor.reset();
  Navigator navigator(plan);
  EXPECT_EQ(navigator.judge(kTeeLeft, way(kColumns_m), true), Verdict::as_planned);
  EXPECT_EQ(navigator.judge(kCross, way(kColumns_m), true), Verdict::puzzling);
  EXPECT_EQ(navigator.judge(kTeeLeft, way(kColumns_m), false), Verdict::puzzling) << "too early";
  EXPECT_EQ(navigator.lost_limit_m(), 0.0);
  EXPECT_EQ(navigator.place(), "no floor to go by");
}

// An end of the line there is no straight on at: nothing explains it.
TEST(Navigator, ACornerThatNothingExplainsIsPuzzling) {
  Navigator navigator = navigator_to("a13");
  EXPECT_EQ(navigator.judge(kCornerLeft, way(0.1), false), Verdict::puzzling);
}

TEST(Navigator, AnotherCodeMayComeWithinTheLongestEdge) {
  EXPECT_NEAR(navigator_to("a13").lost_limit_m(), 1.2 * kColumns_m, 1e-9);
}

// Whatever is told, it judges, and its plan leads to the target.
TEST(Navigator, EveryMisreadLeavesAPlanToTheTarget) {
  for (const NodeSighting& told :
       {kTeeLeft, kCross, kDeadEnd, kCornerLeft, NodeSighting{JunctionCode::tee_right},
        NodeSighting{JunctionCode::straight, false, Bend::fork}}) {
    Navigator navigator = navigator_to("a23");
    for (int k = 0; k < 40; ++k) {
      const Verdict verdict = navigator.judge(told, way(1.0), k % 2 == 0);
      ASSERT_FALSE(navigator.plan().steps.empty());
      ASSERT_EQ(navigator.plan().steps.back().node, "a23");
      if (verdict == Verdict::as_planned || verdict == Verdict::planned_anew) navigator.advance();
    }
  }
}

}  // namespace
}  // namespace lineservo::servo
