#include "servo/executive/node_tracker.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/servo/test_vehicle.h"

namespace lineservo::servo {
namespace {

using testing::TestVehicle;

const Eigen::Vector2d kNode_W(1.0, 0.3);
constexpr int kFrame = TestVehicle::kStepsAt10Hz;

/// A vehicle that passes a node which its camera sees late.
struct Passage {
  TestVehicle vehicle{{{0.5, 0.0}, 0.2, 0.5}};
  NodeTracker tracker{NodeTracker::Options{}};

  void fly(const VelocityCommand& velocity) { vehicle.fly(velocity, kFrame); }
  /// A frame with the node, displaced in H, or without one.
  bool see(const Eigen::Vector2d& off_m = Eigen::Vector2d::Zero(), int delay_steps = 0) {
    const auto& then = vehicle.pose_at_capture(delay_steps);
    return tracker.observe(vehicle.observe({}, delay_steps),
                           testing::in_heading_frame(then, kNode_W) + off_m);
  }
  void miss() { tracker.observe(vehicle.observe({}, 0), std::nullopt); }
  std::optional<Eigen::Vector2d> told() const { return tracker.node_now(vehicle.observe({}, 0)); }
  Eigen::Vector2d truth() const { return testing::in_heading_frame(vehicle.pose(), kNode_W); }
};

TEST(NodeTracker, KnowsNothingAtFirst) {
  Passage p;
  EXPECT_FALSE(p.told().has_value());
  p.miss();
  EXPECT_FALSE(p.told().has_value());
}

TEST(NodeTracker, TakesTheFirstSightingAsItIs) {
  Passage p;
  p.see();
  ASSERT_TRUE(p.told().has_value());
  EXPECT_LT((*p.told() - p.truth()).norm(), 1e-12);
}

TEST(NodeTracker, ALateFrameIsBroughtToThePresent) {
  Passage p;
  p.fly({0.5, 0.2, 0.0, 0.8});
  p.see({0.0, 0.0}, TestVehicle::kStepsIn50Ms);
  EXPECT_LT((*p.told() - p.truth()).norm(), 1e-12);
}

TEST(NodeTracker, CoastsOverMotionAndTurns) {
  Passage p;
  p.see();
  for (int k = 0; k < 9; ++k) {  // 0.9 s without a sighting
    p.fly({0.3, -0.1, 0.0, 1.5});
    p.miss();
    ASSERT_TRUE(p.told().has_value());
    EXPECT_LT((*p.told() - p.truth()).norm(), 1e-12);
  }
}

TEST(NodeTracker, ForgetsANodeThatWasNotSeenForItsMemory) {
  Passage p;
  p.see();
  for (int k = 0; k < 9; ++k) p.fly({}), p.miss();
  EXPECT_TRUE(p.told().has_value());  // 0.9 s
  for (int k = 0; k < 2; ++k) p.fly({}), p.miss();
  EXPECT_FALSE(p.told().has_value());  // 1.1 s
}

TEST(NodeTracker, SightingsKeepItAlive) {
  Passage p;
  for (int k = 0; k < 40; ++k) p.see(), p.fly({});
  EXPECT_LT((*p.told() - p.truth()).norm(), 1e-12);
}

TEST(NodeTracker, NewSightingsCountWithTheirWeight) {
  Passage p;
  p.see();
  p.see({0.02, -0.012});
  EXPECT_LT((*p.told() - (p.truth() + Eigen::Vector2d(0.01, -0.006))).norm(), 1e-12);
  p.see();
  EXPECT_LT((*p.told() - (p.truth() + Eigen::Vector2d(0.005, -0.003))).norm(), 1e-12);
}

TEST(NodeTracker, OneSightingThatJumpsDoesNotCount) {
  Passage p;
  p.see();
  for (int k = 0; k < 5; ++k) {
    EXPECT_FALSE(p.see({0.04, 0.0}));
    EXPECT_TRUE(p.see());
    EXPECT_FALSE(p.see({0.0, -0.05}));
    EXPECT_FALSE(p.see({0.0, 0.05}));  // a jump elsewhere is no confirmation
    EXPECT_TRUE(p.see());
  }
  EXPECT_LT((*p.told() - p.truth()).norm(), 1e-12);
}

TEST(NodeTracker, AJumpThatTheNextSightingConfirmsCounts) {
  Passage p;
  p.see();
  EXPECT_FALSE(p.see({0.1, 0.0}));
  EXPECT_TRUE(p.see({0.1, 0.01}));
  EXPECT_LT((*p.told() - (p.truth() + Eigen::Vector2d(0.05, 0.005))).norm(), 1e-12);
}

TEST(NodeTracker, AnotherNodeBeyondTheGateIsLeftAlone) {
  Passage inside, outside;
  inside.see();
  inside.see({0.249, 0.0});
  inside.see({0.249, 0.0});
  EXPECT_NEAR((*inside.told() - inside.truth()).norm(), 0.1245, 1e-12);
  outside.see();
  outside.see({0.251, 0.0});
  outside.see({0.251, 0.0});
  EXPECT_LT((*outside.told() - outside.truth()).norm(), 1e-12);
}

TEST(NodeTracker, AfterTheMemoryAnotherNodeIsTaken) {
  Passage p;
  p.see();
  for (int k = 0; k < 11; ++k) p.fly({}), p.see({1.0, 0.0});
  EXPECT_LT((*p.told() - (p.truth() + Eigen::Vector2d(1.0, 0.0))).norm(), 1e-12);
}

TEST(NodeTracker, ResetForgets) {
  Passage p;
  p.see();
  p.tracker.reset();
  EXPECT_FALSE(p.told().has_value());
}

TEST(NodeTracker, ASightingThatIsNotFiniteIsNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Passage p;
  p.see({kNaN, 0.0});
  EXPECT_FALSE(p.told().has_value());
  p.see();
  p.see({0.0, kNaN});
  EXPECT_LT((*p.told() - p.truth()).norm(), 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
