#include "servo/law/dock_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/servo/test_vehicle.h"

namespace lineservo::servo {
namespace {

using features::radians;
using testing::Pose;
using testing::TestVehicle;

const Eigen::Vector2d kNode_W(0.0, 0.0), kAhead_W(1.0, 0.0);  // the line through the node is the x axis

/// Docks on the floor's origin, with what a tracker would tell of the node: exact, or from a late frame.
struct Docking {
  explicit Docking(const Pose& start, const Eigen::Vector2d& drift_W_m_s = Eigen::Vector2d::Zero())
      : vehicle(start, drift_W_m_s) {}

  /// One frame. `theta_rad`: none turns about the node at `yaw_rate_rad_s`.
  VelocityCommand tick(bool on_line, double yaw_rate_rad_s) {
    const Observation o = vehicle.observe({}, delay_steps);
    const Pose& then = vehicle.pose_at_capture(delay_steps);
    const Eigen::Vector2d seen_m = testing::in_heading_frame(then, kNode_W);
    law.observe(o, seen_m);
    DockGoal goal;
    goal.point_H_m = after(since_capture(o), seen_m);
    if (on_line) {
      goal.theta_rad = testing::seen_line(then, kNode_W, kAhead_W).theta_rad + since_capture(o).yaw_rad;
    }
    goal.yaw_rate_rad_s = yaw_rate_rad_s;
    const VelocityCommand command = law.hold(o, goal);
    vehicle.fly(command, frame_steps);
    return command;
  }
  void fly(double duration_s, bool on_line, double yaw_rate_rad_s = 0.0) {
    const Time end = vehicle.now() + Time(std::llround(duration_s * 1e9));
    while (vehicle.now() < end) tick(on_line, yaw_rate_rad_s);
  }
  double distance_m() const { return vehicle.pose().p_W.norm(); }

  DockLaw law{DockOptions{}};
  TestVehicle vehicle;
  int frame_steps = TestVehicle::kStepsAt10Hz;
  int delay_steps = TestVehicle::kStepsIn50Ms;
};

TEST(DockLaw, ConvergesFromAllAround) {
  for (int k = 0; k < 12; ++k) {
    for (const double heading_deg : {-15.0, 0.0, 15.0}) {
      const double bearing_rad = radians(30.0 * k);
      Docking docking(
          {0.4 * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)), radians(heading_deg), 0.5});
      docking.fly(8.0, true);
      EXPECT_LT(docking.distance_m(), 0.001) << 30 * k << " deg around";
      EXPECT_NEAR(docking.vehicle.pose().heading_rad, 0.0, radians(0.1));
      EXPECT_NEAR(docking.vehicle.pose().height_m, 0.5, 1e-6);
    }
  }
}

TEST(DockLaw, TheWayInIsStraightAndNeverBackOut) {
  Docking docking({{-0.3, 0.2}, 0.0, 0.5});
  docking.frame_steps = TestVehicle::kStepsAt30Hz;
  docking.delay_steps = 0;
  double last_m = docking.distance_m();
  for (int k = 0; k < 150; ++k) {
    docking.tick(true, 0.0);
    EXPECT_LE(docking.distance_m(), last_m);
    EXPECT_NEAR(docking.vehicle.pose().p_W.x() * 0.2 + docking.vehicle.pose().p_W.y() * 0.3, 0.0, 1e-9);
    last_m = docking.distance_m();
  }
}

TEST(DockLaw, DriftIsLearntAndCancelled) {
  for (const Eigen::Vector2d& drift : {Eigen::Vector2d(0.05, 0.0), Eigen::Vector2d(-0.03, 0.06)}) {
    Docking docking({{0.1, -0.1}, 0.0, 0.5}, drift);
    docking.fly(20.0, true);
    // What is left is the drift during the delay of 50 ms, which the odometry cannot bring to the present.
    EXPECT_NEAR(docking.distance_m(), 0.05 * drift.norm(), 0.0005);
    const VelocityCommand c = docking.tick(true, 0.0);  // the vehicle faces +x: H is W
    EXPECT_NEAR(c.forward_m_s, -drift.x(), 0.002);
    EXPECT_NEAR(c.left_m_s, -drift.y(), 0.002);
  }
}

TEST(DockLaw, TurningKeepsTheNodeBelow) {
  Docking docking({{0.05, 0.05}, 0.0, 0.5});
  docking.fly(5.0, false, 0.6);
  EXPECT_LT(docking.distance_m(), 0.001);
  EXPECT_NEAR(docking.tick(false, 0.6).yaw_rate_rad_s, 0.6, 0.01);
  EXPECT_NEAR(docking.vehicle.pose().heading_rad, 0.6 * seconds(docking.vehicle.now()), 0.15);
}

TEST(DockLaw, ADriftLearntBeforeATurnHoldsThroughIt) {
  // The drift is kept in the odometry's directions, so that a turn does not turn it.
  Docking docking({{0.0, 0.0}, 0.0, 0.5}, {0.04, 0.05});
  docking.frame_steps = TestVehicle::kStepsAt30Hz;
  docking.fly(20.0, true);
  double largest_m = 0.0;
  for (int k = 0; k < 150; ++k) {  // 5 s at 0.6 rad/s: nearly a half turn
    docking.tick(false, 0.6);
    largest_m = std::max(largest_m, docking.distance_m());
  }
  EXPECT_LT(largest_m, 0.05 * 0.064 + 0.001);  // the drift during the delay, and a little
}

TEST(DockLaw, TheSameFrameTwiceTeachesNothingNew) {
  Docking once({{0.0, 0.0}, 0.0, 0.5}, {0.05, 0.0}), twice({{0.0, 0.0}, 0.0, 0.5}, {0.05, 0.0});
  for (int k = 0; k < 50; ++k) {
    const Observation o = twice.vehicle.observe({}, twice.delay_steps);
    twice.law.observe(o,
                      testing::in_heading_frame(twice.vehicle.pose_at_capture(twice.delay_steps), kNode_W));
    EXPECT_EQ(once.tick(true, 0.0).forward_m_s, twice.tick(true, 0.0).forward_m_s);
  }
}

TEST(DockLaw, ResetForgetsTheDrift) {
  Docking docking({{0.0, 0.0}, 0.0, 0.5}, {0.05, 0.0});
  docking.fly(20.0, true);
  docking.law.reset();
  const VelocityCommand c = docking.law.hold(docking.vehicle.observe({}, 0), {});
  EXPECT_EQ(c.forward_m_s, 0.0);
  EXPECT_EQ(c.left_m_s, 0.0);
}

TEST(DockLaw, ABadSightingLeavesNothingBehind) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Docking docking({{0.1, 0.0}, 0.0, 0.5});
  docking.tick(true, 0.0);
  docking.law.observe(docking.vehicle.observe({}, 0), {kNaN, 0.0});
  const VelocityCommand bad = docking.law.hold(docking.vehicle.observe({}, 0), {{kNaN, 0.0}, 0.0, 0.0, 0.5});
  EXPECT_EQ(bad.forward_m_s, 0.0);  // at rest, not NaN
  docking.fly(8.0, true);
  EXPECT_LT(docking.distance_m(), 0.001);
}

}  // namespace
}  // namespace lineservo::servo
