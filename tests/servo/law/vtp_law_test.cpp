#include "servo/law/vtp_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lineservo::servo {
namespace {

constexpr double kPublished_m_s = 0.5225;  // 27.5 px · 0.0038 m/px / 0.2 s
const FollowGoal kAsPublished{kPublished_m_s, 0.5};

/// A frame with the target `forward`, `left` of the image centre, on an arc of any size.
Observation seen(int millisecond, double forward, double left) {
  Observation o;
  o.now = o.captured = std::chrono::milliseconds(millisecond);
  o.features.law.target = features::LevelPoint{-left, -forward};
  o.estimate.height_m = o.estimate.capture_height_m = 0.5;
  return o;
}

Observation unseen(int millisecond) {
  Observation o = seen(millisecond, 1.0, 0.0);
  o.features.law.target.reset();
  return o;
}

VelocityCommand follow(VtpLaw& law, const Observation& o, const FollowGoal& goal = kAsPublished) {
  return std::get<VelocityCommand>(law.follow(o, goal));
}

TEST(VtpLaw, ThePublishedSpeedIsThatOfItsStepsOnItsArc) {
  EXPECT_NEAR(published_speed_m_s(VtpOptions{}), kPublished_m_s, 1e-12);
}

TEST(VtpLaw, StepsByHand) {
  // Targets of 27.5 px at (27.5, 0), (22, 16.5), (22, 16.5), (27.5, 0): forward, left. Steps in mm for 3.8 a
  // px and 2 a px of change from 2 px on:
  //   104.5, 0        first: no change yet
  //   83.6 − 11, 62.7 + 33
  //   83.6, 62.7      no change
  //   104.5 + 11, 0 − 33
  VtpLaw law({});
  const std::vector<std::array<double, 4>> steps = {
      {27.5, 0.0, 104.5, 0.0}, {22.0, 16.5, 72.6, 95.7}, {22.0, 16.5, 83.6, 62.7}, {27.5, 0.0, 115.5, -33.0}};
  int k = 0;
  for (const auto& [forward_px, left_px, forward_mm, left_mm] : steps) {
    const VelocityCommand c = follow(law, seen(200 * k++, forward_px, left_px));
    EXPECT_NEAR(c.forward_m_s, forward_mm * 1e-3 / 0.2, 1e-9) << "step " << k;
    EXPECT_NEAR(c.left_m_s, left_mm * 1e-3 / 0.2, 1e-9) << "step " << k;
    EXPECT_EQ(c.yaw_rate_rad_s, 0.0);
  }
}

TEST(VtpLaw, AChangeBelowTwoPixelsDoesNotCount) {
  const auto left_after = [](double left_px) {
    VtpLaw law({});
    follow(law, seen(0, 27.5, 0.0));
    return follow(law, seen(200, std::sqrt(27.5 * 27.5 - left_px * left_px), left_px)).left_m_s;
  };
  EXPECT_NEAR(left_after(1.9), 0.0038 * 1.9 / 0.2, 1e-9);
  EXPECT_NEAR(left_after(2.1), (0.0038 + 0.002) * 2.1 / 0.2, 1e-9);
}

TEST(VtpLaw, MovesTowardsTheTarget) {
  VtpLaw left({}), right({}), back({});
  EXPECT_GT(follow(left, seen(0, 0.2, 0.1)).left_m_s, 0.0);
  EXPECT_LT(follow(right, seen(0, 0.2, -0.1)).left_m_s, 0.0);
  EXPECT_LT(follow(back, seen(0, -0.2, 0.1)).forward_m_s, 0.0);  // the heading is free: backward too
}

TEST(VtpLaw, ATargetStraightAheadIsApproachedAtTheSpeedAskedForWhateverTheArc) {
  for (const double radius : {0.08, 0.2, 0.58}) {
    VtpLaw law({});
    EXPECT_NEAR(follow(law, seen(0, radius, 0.0), {0.1, 0.5}).forward_m_s, 0.1, 1e-12);
  }
}

TEST(VtpLaw, StepsFiveTimesASecondAtAnyFrameRate) {
  for (const int period_ms : {20, 33, 100}) {
    VtpLaw law({});
    int steps = 0;
    double before_m_s = 0.0;
    for (int ms = 0; ms < 2000; ms += period_ms) {
      const double aside = 0.001 * (ms + 1);  // a new direction in every frame
      const double left_m_s = follow(law, seen(ms, 1.0, aside)).left_m_s;
      steps += int{left_m_s != before_m_s};
      before_m_s = left_m_s;
    }
    const int expected = period_ms == 33 ? 11 : 10;  // 198 ms are the whole frames nearest to a step
    EXPECT_EQ(steps, expected) << period_ms << " ms";
  }
}

TEST(VtpLaw, WithoutATargetItStaysAndHoldsTheHeight) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  VtpLaw law({});
  follow(law, seen(0, 1.0, 0.2));
  for (Observation o : {unseen(200), seen(400, kNaN, 0.0), seen(600, 0.0, 0.0)}) {
    o.estimate.height_m = 0.4;
    const VelocityCommand c = follow(law, o);
    EXPECT_EQ(c.forward_m_s, 0.0);
    EXPECT_EQ(c.left_m_s, 0.0);
    EXPECT_GT(c.up_m_s, 0.0);
  }
}

/// A frame with the end marker's centre `forward`, `left` of the image centre, in pixels of vtp's camera.
Observation marker_seen(int millisecond, double forward_px, double left_px) {
  Observation o = unseen(millisecond);
  o.features.start_marker = features::LevelPoint{-left_px / 145.0, -forward_px / 145.0};
  return o;
}

TEST(VtpLaw, AboveTheEndMarkerItStepsTowardsItsCentre) {
  VtpLaw law({});
  const auto c = law.hover(marker_seen(0, 10.0, -5.0), kAsPublished);
  ASSERT_TRUE(c);
  EXPECT_NEAR(std::get<VelocityCommand>(*c).forward_m_s, 10.0 * 0.0022 / 0.2, 1e-9);
  EXPECT_NEAR(std::get<VelocityCommand>(*c).left_m_s, -5.0 * 0.0022 / 0.2, 1e-9);
  const auto held = law.hover(marker_seen(100, 0.0, 0.0), kAsPublished);
  EXPECT_EQ(std::get<VelocityCommand>(*held).forward_m_s, std::get<VelocityCommand>(*c).forward_m_s)
      << "a step lasts 0.2 s";
  EXPECT_EQ(std::get<VelocityCommand>(*law.hover(marker_seen(200, 0.0, 0.0), kAsPublished)).forward_m_s, 0.0);
}

TEST(VtpLaw, WithoutAMarkerTheVehicleBrakesAndStays) {
  VtpLaw law({});
  EXPECT_FALSE(law.hover(unseen(0), kAsPublished));
}

TEST(VtpLaw, ResetForgetsTheErrorAndTheTimeOfTheLastStep) {
  VtpLaw law({});
  follow(law, seen(0, 1.0, 0.0));
  law.reset();
  EXPECT_NEAR(follow(law, seen(20, 0.8, 0.6)).left_m_s, 0.0038 * 16.5 / 0.2, 1e-9);
}

}  // namespace
}  // namespace lineservo::servo
