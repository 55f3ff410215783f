#include "servo/law/ibvs_line_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/servo/test_vehicle.h"

namespace lineservo::servo {
namespace {

using features::radians;
using testing::Pose;
using testing::TestVehicle;

constexpr FollowGoal kGoal{0.2, 0.5};
constexpr int kFrame = TestVehicle::kStepsAt30Hz;
const Eigen::Vector2d kBehind_W(-100.0, 0.0), kAhead_W(100.0, 0.0);  // the line is the x axis

features::FrameFeatures line_from(const Pose& pose) {
  features::FrameFeatures frame;
  frame.lines.push_back(testing::seen_line(pose, kBehind_W, kAhead_W));
  return frame;
}

/// A vehicle over the line, one frame a tick; the frames can be taken away or spoilt.
struct Flight {
  explicit Flight(const Pose& start, const Eigen::Vector2d& drift_W_m_s = Eigen::Vector2d::Zero())
      : vehicle(start, drift_W_m_s) {}

  VelocityCommand tick(const features::FrameFeatures& frame) {
    const auto command = std::get<VelocityCommand>(law.follow(vehicle.observe(frame, 0), kGoal));
    vehicle.fly(command, kFrame);
    return command;
  }
  VelocityCommand see() { return tick(line_from(vehicle.pose())); }
  VelocityCommand blind() { return tick({}); }
  void see_for(double duration_s) {
    for (int k = 0; k < std::lround(duration_s * 30.0); ++k) see();
  }

  IbvsLineLaw law{IbvsLineOptions{}};
  TestVehicle vehicle;
};

TEST(IbvsLineLaw, OnTheLineItGoesStraightAheadAtTheSpeedAskedFor) {
  Flight flight({{0.0, 0.0}, 0.0, 0.5});
  const VelocityCommand c = flight.see();
  EXPECT_NEAR(c.forward_m_s, 0.2, 1e-12);
  EXPECT_NEAR(c.left_m_s, 0.0, 1e-12);
  EXPECT_NEAR(c.up_m_s, 0.0, 1e-12);
  EXPECT_NEAR(c.yaw_rate_rad_s, 0.0, 1e-12);
}

/// A line that bends by κ (to the right when positive), straight under the vehicle.
features::FrameFeatures bend(double curvature_inv_m) {
  features::FrameFeatures frame = line_from({{0.0, 0.0}, 0.0, 0.5});
  frame.lines.front().curvature = curvature_inv_m * 0.5;
  return frame;
}

TEST(IbvsLineLaw, TurnsWithALineThatBends) {
  EXPECT_NEAR(Flight({{0.0, 0.0}, 0.0, 0.5}).tick(bend(0.5)).yaw_rate_rad_s, -0.5 * kGoal.speed_m_s, 1e-12);
  EXPECT_NEAR(Flight({{0.0, 0.0}, 0.0, 0.5}).tick(bend(-0.5)).yaw_rate_rad_s, 0.5 * kGoal.speed_m_s, 1e-12);
}

TEST(IbvsLineLaw, IsAsFastInABendAsItCanFollow) {
  // v ≤ √(a / κ) and v ≤ ω / κ
  const auto speed_in = [](double curvature_inv_m, double acceleration_m_s2, double yaw_rate_rad_s) {
    IbvsLineOptions options;
    options.bend_acceleration_m_s2 = acceleration_m_s2;
    options.bend_yaw_rate_rad_s = yaw_rate_rad_s;
    IbvsLineLaw law(options);
    const TestVehicle vehicle({{0.0, 0.0}, 0.0, 0.5});
    return std::get<VelocityCommand>(law.follow(vehicle.observe(bend(curvature_inv_m), 0), {1.0, 0.5}))
        .forward_m_s;
  };
  EXPECT_NEAR(speed_in(0.5, 0.18, 3.0), 0.6, 1e-9);
  EXPECT_NEAR(speed_in(-0.5, 5.0, 0.2), 0.4, 1e-9);
  EXPECT_NEAR(speed_in(0.01, 5.0, 3.0), 1.0, 1e-9);
}

TEST(IbvsLineLaw, FirstStepGoesToTheLine) {
  EXPECT_LT(Flight({{0.0, 0.1}, 0.0, 0.5}).see().left_m_s, -0.05);
  EXPECT_GT(Flight({{0.0, -0.1}, 0.0, 0.5}).see().left_m_s, 0.05);
  EXPECT_LT(Flight({{0.0, 0.0}, 0.2, 0.5}).see().yaw_rate_rad_s, -0.1);
  EXPECT_GT(Flight({{0.0, 0.0}, -0.2, 0.5}).see().yaw_rate_rad_s, 0.1);
  EXPECT_LT(Flight({{0.0, 0.0}, 0.0, 0.6}).see().up_m_s, -0.05);
}

TEST(IbvsLineLaw, SlowsDownTowardsTheBorderOfTheView) {
  // Forward speed · (1 − (ρ/0.6)²): three quarters at half the margin, nil at the margin and beyond.
  EXPECT_NEAR(Flight({{0.0, 0.15}, 0.0, 0.5}).see().forward_m_s, 0.75 * 0.2, 1e-12);
  EXPECT_NEAR(Flight({{0.0, -0.15}, 0.0, 0.5}).see().forward_m_s, 0.75 * 0.2, 1e-12);
  EXPECT_NEAR(Flight({{0.0, 0.30}, 0.0, 0.5}).see().forward_m_s, 0.0, 1e-12);
  EXPECT_NEAR(Flight({{0.0, 0.40}, 0.0, 0.5}).see().forward_m_s, 0.0, 1e-12);
  // Of the angle the same, with 0.6 rad; what is left goes along the line: · cos²θ of it forward.
  EXPECT_NEAR(Flight({{0.0, 0.0}, 0.3, 0.5}).see().forward_m_s, 0.75 * 0.2 * std::pow(std::cos(0.3), 2),
              1e-12);
  EXPECT_NEAR(Flight({{0.0, 0.0}, 0.7, 0.5}).see().forward_m_s, 0.0, 1e-12);
}

TEST(IbvsLineLaw, ADelayedFrameIsBroughtToThePresent) {
  // Taken at one place, used at another: the command is that of a frame taken where the vehicle is now.
  TestVehicle vehicle({{0.0, 0.12}, radians(8.0), 0.5});
  vehicle.fly(VelocityCommand{0.4, -0.3, 0.0, 0.5}, 2 * TestVehicle::kStepsIn50Ms);
  const int delay = TestVehicle::kStepsIn50Ms;
  IbvsLineLaw delayed{IbvsLineOptions{}}, fresh{IbvsLineOptions{}};
  const auto with_delay = std::get<VelocityCommand>(
      delayed.follow(vehicle.observe(line_from(vehicle.pose_at_capture(delay)), delay), kGoal));
  const auto without =
      std::get<VelocityCommand>(fresh.follow(vehicle.observe(line_from(vehicle.pose()), 0), kGoal));
  EXPECT_NEAR(with_delay.forward_m_s, without.forward_m_s, 1e-9);
  EXPECT_NEAR(with_delay.left_m_s, without.left_m_s, 1e-9);
  EXPECT_NEAR(with_delay.yaw_rate_rad_s, without.yaw_rate_rad_s, 1e-9);
}

TEST(IbvsLineLaw, AClimbSinceTheFrameWasTakenDoesNotMoveTheLine) {
  // The image scales with 1/h; the line stays where it is on the floor.
  TestVehicle vehicle({{0.0, 0.12}, 0.0, 0.40});
  vehicle.fly(VelocityCommand{0.0, 0.0, 0.4, 0.0}, TestVehicle::kStepsIn50Ms);
  const int delay = TestVehicle::kStepsIn50Ms;
  IbvsLineLaw delayed{IbvsLineOptions{}}, fresh{IbvsLineOptions{}};
  const auto with_delay = std::get<VelocityCommand>(
      delayed.follow(vehicle.observe(line_from(vehicle.pose_at_capture(delay)), delay), kGoal));
  const auto without =
      std::get<VelocityCommand>(fresh.follow(vehicle.observe(line_from(vehicle.pose()), 0), kGoal));
  EXPECT_NEAR(with_delay.left_m_s, without.left_m_s, 1e-9);
  EXPECT_NEAR(with_delay.forward_m_s, without.forward_m_s, 1e-9);
}

TEST(IbvsLineLaw, ALineLostForAMomentIsFollowedByOdometry) {
  Flight flight({{0.0, 0.1}, radians(10.0), 0.5}), seeing({{0.0, 0.1}, radians(10.0), 0.5});
  flight.see();
  seeing.see();
  for (int k = 0; k < 9; ++k) {  // 0.3 s
    const VelocityCommand blind = flight.blind(), seen = seeing.see();
    EXPECT_NEAR(blind.forward_m_s, seen.forward_m_s, 1e-9);
    EXPECT_NEAR(blind.left_m_s, seen.left_m_s, 1e-9);
    EXPECT_NEAR(blind.yaw_rate_rad_s, seen.yaw_rate_rad_s, 1e-9);
  }
}

TEST(IbvsLineLaw, ALineLostForLongIsNotFollowed) {
  Flight flight({{0.0, 0.1}, radians(10.0), 0.5});
  flight.see();
  VelocityCommand c = flight.blind();
  EXPECT_GT(c.forward_m_s, 0.05);
  for (int k = 0; k < 60; ++k) c = flight.blind();  // 2 s
  EXPECT_EQ(c.forward_m_s, 0.0);
  EXPECT_EQ(c.left_m_s, 0.0);
  EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
}

TEST(IbvsLineLaw, WithoutALineItHoldsTheHeight) {
  EXPECT_GT(Flight({{0.0, 0.0}, 0.0, 0.4}).blind().up_m_s, 0.0);
  EXPECT_LT(Flight({{0.0, 0.0}, 0.0, 0.6}).blind().up_m_s, 0.0);
}

TEST(IbvsLineLaw, ALineThatComesBackIsFollowedAgain) {
  Flight flight({{0.0, 0.05}, 0.0, 0.5});
  flight.see_for(1.0);
  for (int k = 0; k < 60; ++k) flight.blind();
  flight.see_for(6.0);
  EXPECT_NEAR(flight.vehicle.pose().p_W.y(), 0.0, 0.001);
}

TEST(IbvsLineLaw, LearnsADriftAndFeedsItForward) {
  Flight flight({{0.0, 0.0}, 0.0, 0.5}, {0.0, 0.05});
  flight.see_for(20.0);
  EXPECT_NEAR(flight.vehicle.pose().p_W.y(), 0.0, 0.0005);
  EXPECT_NEAR(flight.see().left_m_s, -0.05, 0.001);
}

TEST(IbvsLineLaw, ResetForgetsTheLineAndTheDrift) {
  Flight flight({{0.0, 0.0}, 0.0, 0.5}, {0.0, 0.05});
  flight.see_for(20.0);
  flight.law.reset();
  EXPECT_EQ(flight.blind().forward_m_s, 0.0);  // nothing to coast on
  flight.law.reset();
  const double left_m = flight.vehicle.pose().p_W.y();
  const double gain = IbvsLineOptions{}.gain.at_zero;  // nothing else is left
  EXPECT_NEAR(flight.see().left_m_s, -gain * left_m, 1e-3);
}

TEST(IbvsLineLaw, TheSameFrameTwiceTeachesNothingNew) {
  // A control tick without a new frame brings the last one again: the drift is learnt as if once.
  Flight once({{0.0, 0.0}, 0.0, 0.5}, {0.0, 0.05}), twice({{0.0, 0.0}, 0.0, 0.5}, {0.0, 0.05});
  for (int k = 0; k < 90; ++k) {
    const auto frame = line_from(twice.vehicle.pose());
    twice.law.follow(twice.vehicle.observe(frame, 0), kGoal);
    const VelocityCommand again = twice.tick(frame), expected = once.see();
    EXPECT_NEAR(again.left_m_s, expected.left_m_s, 1e-9) << "frame " << k;
  }
}

TEST(IbvsLineLaw, ABadFrameIsNoFrame) {
  // The bad line is not followed (the good one before is, by odometry), and it leaves nothing behind.
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [rho, theta_rad] : {std::pair{kNaN, 0.0}, {0.1, kNaN}, {1.0 / 0.0, 0.0}}) {
    Flight flight({{0.0, 0.1}, 0.0, 0.5}), seeing({{0.0, 0.1}, 0.0, 0.5});
    flight.see();
    seeing.see();
    features::FrameFeatures bad = line_from(flight.vehicle.pose());
    bad.lines.front().rho = rho;
    bad.lines.front().theta_rad = theta_rad;
    EXPECT_NEAR(flight.tick(bad).left_m_s, seeing.see().left_m_s, 1e-9);
    for (int k = 0; k < 30; ++k) EXPECT_NEAR(flight.see().left_m_s, seeing.see().left_m_s, 1e-9);
  }
}

}  // namespace
}  // namespace lineservo::servo
