#include "servo/law/ibvs_point_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "features/geometry/angles.h"
#include "tests/servo/test_vehicle.h"

namespace lineservo::servo {
namespace {

using features::JunctionCode;
using features::radians;
using testing::Pose;
using testing::TestVehicle;

constexpr FollowGoal kGoal{0.2, 0.5};
constexpr int kFrame = TestVehicle::kStepsAt30Hz;
constexpr double kAhead_m = 0.2;
const Eigen::Vector2d kBehind_W(-100.0, 0.0), kFarAhead_W(100.0, 0.0);  // the line is the x axis

/// The point of the x axis that is followed: where it crosses the circle ahead, or below the vehicle.
Eigen::Vector2d followed_W(const Pose& pose, PathPoint which) {
  const double y = pose.p_W.y();
  const double ahead_m =
      which == PathPoint::target ? std::sqrt(std::max(0.0, kAhead_m * kAhead_m - y * y)) : 0.0;
  return {pose.p_W.x() + ahead_m, 0.0};
}

features::FrameFeatures frame_from(const Pose& pose, PathPoint which) {
  features::FrameFeatures frame;
  frame.lines.push_back(testing::seen_line(pose, kBehind_W, kFarAhead_W));
  frame.code = {JunctionCode::straight, JunctionCode::straight, JunctionCode::straight};
  const features::LevelPoint point = testing::seen_point(pose, followed_W(pose, which));
  (which == PathPoint::target ? frame.law.target : frame.law.centroid) = point;
  return frame;
}

/// A vehicle over the line, one frame a tick; the frames can be taken away or spoilt.
struct Flight {
  Flight(PathPoint point, const Pose& start, double drift_m_s = 0.0)
      : which(point), law(point, {}), vehicle(start, {0.0, drift_m_s}) {}

  features::FrameFeatures frame() const { return frame_from(vehicle.pose(), which); }
  VelocityCommand tick(const features::FrameFeatures& frame) {
    const auto command = std::get<VelocityCommand>(law.follow(vehicle.observe(frame, 0), kGoal));
    vehicle.fly(command, kFrame);
    return command;
  }
  VelocityCommand see() { return tick(frame()); }
  void see_for(double duration_s) {
    for (int k = 0; k < std::lround(duration_s * 30.0); ++k) see();
  }
  double left_m() const { return vehicle.pose().p_W.y(); }

  PathPoint which;
  IbvsPointLaw law;
  TestVehicle vehicle;
};

class IbvsPointLawTest : public ::testing::TestWithParam<PathPoint> {};

INSTANTIATE_TEST_SUITE_P(Points, IbvsPointLawTest, ::testing::Values(PathPoint::centroid, PathPoint::target),
                         [](const auto& tested) {
                           return tested.param == PathPoint::centroid ? "Centroid" : "Target";
                         });

TEST_P(IbvsPointLawTest, OnTheLineItGoesStraightAheadAtTheSpeedAskedFor) {
  const VelocityCommand c = Flight(GetParam(), {{0.0, 0.0}, 0.0, 0.5}).see();
  EXPECT_NEAR(c.forward_m_s, 0.2, 1e-12);
  EXPECT_NEAR(c.left_m_s, 0.0, 1e-12);
  EXPECT_NEAR(c.up_m_s, 0.0, 1e-12);
  EXPECT_NEAR(c.yaw_rate_rad_s, 0.0, 1e-12);
}

TEST_P(IbvsPointLawTest, FirstStepGoesToTheLine) {
  EXPECT_LT(Flight(GetParam(), {{0.0, 0.1}, 0.0, 0.5}).see().left_m_s, -0.05);
  EXPECT_GT(Flight(GetParam(), {{0.0, -0.1}, 0.0, 0.5}).see().left_m_s, 0.05);
  EXPECT_LT(Flight(GetParam(), {{0.0, 0.0}, 0.0, 0.6}).see().up_m_s, -0.05);
}

TEST_P(IbvsPointLawTest, SlowsDownTowardsTheBorderOfTheView) {
  EXPECT_NEAR(Flight(GetParam(), {{0.0, 0.15}, 0.0, 0.5}).see().forward_m_s, 0.75 * 0.2, 1e-12);
  EXPECT_NEAR(Flight(GetParam(), {{0.0, -0.40}, 0.0, 0.5}).see().forward_m_s, 0.0, 1e-12);
}

TEST_P(IbvsPointLawTest, FromEitherSideItSettlesOnTheLine) {
  for (const double left_m : {-0.15, 0.15}) {
    Flight flight(GetParam(), {{0.0, left_m}, 0.0, 0.5});
    flight.see_for(8.0);
    EXPECT_NEAR(flight.left_m(), 0.0, 0.001);
  }
}

TEST_P(IbvsPointLawTest, ADriftIsLearntAndFedForward) {
  for (const double drift_m_s : {-0.05, 0.05}) {
    Flight flight(GetParam(), {{0.0, 0.0}, 0.0, 0.5}, drift_m_s);
    flight.see_for(20.0);
    EXPECT_NEAR(flight.left_m(), 0.0, 0.0005);
    EXPECT_NEAR(flight.see().left_m_s, -drift_m_s, 0.001);
  }
}

TEST_P(IbvsPointLawTest, ADelayedFrameIsBroughtToThePresent) {
  const int delay = TestVehicle::kStepsIn50Ms;
  TestVehicle vehicle({{0.0, 0.1}, 0.0, 0.5});
  vehicle.fly(VelocityCommand{0.0, -0.3, 0.0, 0.0}, 2 * delay);
  IbvsPointLaw delayed(GetParam(), {}), fresh(GetParam(), {});
  const auto with_delay = std::get<VelocityCommand>(
      delayed.follow(vehicle.observe(frame_from(vehicle.pose_at_capture(delay), GetParam()), delay), kGoal));
  const auto without = std::get<VelocityCommand>(
      fresh.follow(vehicle.observe(frame_from(vehicle.pose(), GetParam()), 0), kGoal));
  EXPECT_NEAR(with_delay.left_m_s, without.left_m_s, 1e-9);
}

TEST_P(IbvsPointLawTest, AJunctionIsPassedStraightWithTheDriftLearnt) {
  // Whatever the point does meanwhile: it is pulled 0.1 m aside here.
  Flight flight(GetParam(), {{0.0, 0.0}, 0.0, 0.5}, 0.03);
  flight.see_for(25.0);
  for (int k = 0; k < 150; ++k) {  // 5 s
    features::FrameFeatures frame = flight.frame();
    frame.code.raw = frame.code.smoothed = JunctionCode::tee_left;
    for (auto* point : {&frame.law.centroid, &frame.law.target})
      if (*point) (*point)->x -= 0.2;
    const VelocityCommand c = flight.tick(frame);
    EXPECT_NEAR(c.forward_m_s, 0.2, 1e-6);
    EXPECT_NEAR(c.left_m_s, -0.03, 0.002);
  }
  EXPECT_NEAR(flight.left_m(), 0.0, 0.005);
}

TEST_P(IbvsPointLawTest, AnyOtherSignOfAJunctionTakesThePointAway) {
  const auto left_m_s = [&](const std::function<void(features::FrameFeatures&)>& spoil) {
    Flight flight(GetParam(), {{0.0, 0.1}, 0.0, 0.5});
    features::FrameFeatures frame = flight.frame();
    spoil(frame);
    return flight.tick(frame).left_m_s;
  };
  EXPECT_LT(left_m_s([](auto&) {}), -0.05);
  EXPECT_EQ(left_m_s([](auto& frame) { frame.code.raw = JunctionCode::cross; }), 0.0);
  EXPECT_EQ(left_m_s([](auto& frame) { frame.code.smoothed = JunctionCode::cross; }), 0.0);
  EXPECT_EQ(left_m_s([](auto& frame) { frame.junction = features::JunctionFeature{}; }), 0.0);
  EXPECT_EQ(left_m_s([](auto& frame) { frame.lines.push_back(frame.lines.front()); }), 0.0);
}

TEST_P(IbvsPointLawTest, ThePullOfAnArmThatComesIntoViewIsNotCarriedOnAsADrift) {
  // Half a second of a point that runs away sideways, not yet told as a junction; then the junction.
  Flight flight(GetParam(), {{0.0, 0.0}, 0.0, 0.5});
  flight.see_for(5.0);
  for (int k = 0; k < 15; ++k) {
    features::FrameFeatures frame = flight.frame();
    for (auto* point : {&frame.law.centroid, &frame.law.target})
      if (*point) (*point)->x += 0.01 * k;
    flight.tick(frame);
  }
  VelocityCommand c;
  for (int k = 0; k < 60; ++k) {  // 2 s
    features::FrameFeatures frame = flight.frame();
    frame.code.raw = frame.code.smoothed = JunctionCode::tee_right;
    c = flight.tick(frame);
  }
  EXPECT_LT(std::abs(c.left_m_s), 0.02);  // the point ran at 0.15 m/s
}

TEST_P(IbvsPointLawTest, WithNothingInViewItCoastsAndThenStays) {
  Flight flight(GetParam(), {{0.0, 0.1}, 0.0, 0.5});
  flight.see();
  EXPECT_LT(flight.tick({}).left_m_s, -0.05);
  VelocityCommand c;
  for (int k = 0; k < 30; ++k) c = flight.tick({});
  EXPECT_EQ(c.forward_m_s, 0.0);
  EXPECT_EQ(c.left_m_s, 0.0);
}

TEST_P(IbvsPointLawTest, ResetForgetsThePointAndTheDrift) {
  Flight flight(GetParam(), {{0.0, 0.0}, 0.0, 0.5}, 0.05);
  flight.see_for(20.0);
  flight.law.reset();
  features::FrameFeatures frame = flight.frame();
  frame.law = {};
  EXPECT_EQ(flight.tick(frame).left_m_s, 0.0);
}

TEST_P(IbvsPointLawTest, ABadPointIsNoPoint) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Flight flight(GetParam(), {{0.0, 0.1}, 0.0, 0.5});
  features::FrameFeatures frame = flight.frame();
  frame.law.centroid = frame.law.target = features::LevelPoint{kNaN, 0.0};
  const VelocityCommand c = flight.tick(frame);
  EXPECT_TRUE(is_finite(Command(c)));
  EXPECT_EQ(c.left_m_s, 0.0);
}

TEST_P(IbvsPointLawTest, TheYawThatTheExecutiveHoldsIsTakenIntoAccount) {
  // Turned by 20° with a yaw back to the line, the point has to follow ẋ = −λ·x none the less.
  const Pose pose{{0.0, 0.05}, radians(20.0), 0.5};
  const TestVehicle vehicle(pose);
  IbvsPointLaw law(GetParam(), {.gain = {1.0, 1.0, 0.0}});
  FollowGoal goal{0.0, 0.5};
  goal.yaw_rate_rad_s = -0.1;
  const auto c =
      std::get<VelocityCommand>(law.follow(vehicle.observe(frame_from(pose, GetParam()), 0), goal));
  const features::LevelPoint p = testing::seen_point(pose, followed_W(pose, GetParam()));
  EXPECT_EQ(c.yaw_rate_rad_s, -0.1);
  EXPECT_NEAR(c.left_m_s / 0.5 - p.y * -0.1, -p.x, 1e-9);
}

}  // namespace
}  // namespace lineservo::servo
