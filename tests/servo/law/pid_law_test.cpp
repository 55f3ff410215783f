#include "servo/law/pid_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>
#include <vector>

namespace lineservo::servo {
namespace {

using features::JunctionCode;

constexpr FollowGoal kGoal{0.1, 0.5};

Observation seen(double centroid_px, JunctionCode smoothed = JunctionCode::straight) {
  Observation o;
  o.features.centroid_px = features::PixelPoint{centroid_px, 200.0};
  o.features.code.smoothed = smoothed;
  o.estimate.height_m = 0.5;
  return o;
}

VelocityCommand follow(PidLaw& law, const Observation& o) {
  return std::get<VelocityCommand>(law.follow(o, kGoal));
}

TEST(PidLaw, SequenceByHand) {
  // e_n = (c_x − 200) / 200 with K_p = 0.5, K_i = 0.01, K_d = 0.25 a call; in the dead zone e = 0 and I = 0.
  //   c_x      e       I       Δe      0.5·e + 0.01·I + 0.25·Δe
  //   240      0.2     0.2     0.2     0.100 + 0.002 + 0.050 = 0.152
  //   260      0.3     0.5     0.1     0.150 + 0.005 + 0.025 = 0.180
  //   220      0.1     0.6    −0.2     0.050 + 0.006 − 0.050 = 0.006
  //   205      0       0      −0.1     0     + 0     − 0.025 = −0.025    (0.025 < 0.05: dead zone)
  //   195      0       0       0       0
  //   160     −0.2    −0.2    −0.2     −0.152                            (the integral began anew)
  const std::vector<std::pair<double, double>> sequence = {{240, 0.152},  {260, 0.180}, {220, 0.006},
                                                           {205, -0.025}, {195, 0.0},   {160, -0.152}};
  PidLaw law({});
  for (const auto& [centroid_px, output] : sequence) {
    const VelocityCommand c = follow(law, seen(centroid_px));
    EXPECT_NEAR(c.left_m_s, -output, 1e-12) << centroid_px;  // to the right of the image is −left
    EXPECT_EQ(c.forward_m_s, 0.1);
    EXPECT_EQ(c.yaw_rate_rad_s, 0.0);  // the heading is not its business
  }
}

TEST(PidLaw, MovesTowardsTheLine) {
  PidLaw left({}), right({});
  EXPECT_GT(follow(left, seen(150.0)).left_m_s, 0.0);
  EXPECT_LT(follow(right, seen(250.0)).left_m_s, 0.0);
}

TEST(PidLaw, TheDeadZoneEndsAtItsBound) {
  PidLaw inside({}), outside({});
  EXPECT_EQ(follow(inside, seen(200.0 + 0.049 * 200.0)).left_m_s, 0.0);
  EXPECT_NEAR(follow(outside, seen(200.0 + 0.051 * 200.0)).left_m_s, -(0.5 + 0.01 + 0.25) * 0.051, 1e-12);
}

TEST(PidLaw, GainsArePerCallWhateverTheTime) {
  PidLaw slow({}), fast({});
  for (int k = 0; k < 5; ++k) {
    Observation at_1_s = seen(240.0), at_10_ms = seen(240.0);
    at_1_s.now = at_1_s.captured = std::chrono::seconds(k);
    at_10_ms.now = at_10_ms.captured = std::chrono::milliseconds(10 * k);
    EXPECT_EQ(follow(slow, at_1_s).left_m_s, follow(fast, at_10_ms).left_m_s);
  }
}

TEST(PidLaw, TheIntegralIsLimitedOnBothSides) {
  for (const double side : {-1.0, 1.0}) {
    PidLaw law({});
    VelocityCommand c;
    for (int k = 0; k < 200; ++k) c = follow(law, seen(200.0 + side * 100.0));
    EXPECT_NEAR(c.left_m_s, -side * (0.5 * 0.5 + 0.01 * 50.0), 1e-12);
  }
}

TEST(PidLaw, ActsOnPlainLineOnly) {
  for (int code = 0; code < features::kJunctionCodes; ++code) {
    PidLaw law({});
    const bool is_straight = code == static_cast<int>(JunctionCode::straight);
    const VelocityCommand c = follow(law, seen(260.0, static_cast<JunctionCode>(code)));
    EXPECT_EQ(c.left_m_s != 0.0, is_straight) << "J" << code;
    EXPECT_EQ(c.forward_m_s, 0.1);
  }
}

TEST(PidLaw, WithoutALineItStaysSidewaysAtRest) {
  PidLaw law({});
  Observation nothing;
  nothing.estimate.height_m = 0.5;
  EXPECT_EQ(follow(law, nothing).left_m_s, 0.0);
}

/// The yaw rate of a second frame, a second after the first, with the same centroid.
double yaw_on_a_curve(double centroid_px, const PidOptions& options = {}, double height_m = 0.5) {
  PidLaw law(options);
  Observation o = seen(centroid_px, JunctionCode::unrecognised);
  o.estimate.height_m = height_m;
  law.follow(o, {0.1, 0.5, true});
  o.captured += std::chrono::seconds(1);
  return std::get<VelocityCommand>(law.follow(o, {0.1, 0.5, true})).yaw_rate_rad_s;
}

TEST(PidLaw, OnACurveItYawsByTheAngleOfALargeOffset) {
  // ψ = atan(Δx / 320) for |Δx| > 45 / (2·0.5) = 45 px, clipped to 55 px, within the frame's second.
  EXPECT_EQ(yaw_on_a_curve(245.0), 0.0);
  EXPECT_NEAR(yaw_on_a_curve(250.0), -std::atan(50.0 / 320.0), 1e-12);  // to the right: clockwise
  EXPECT_NEAR(yaw_on_a_curve(150.0), std::atan(50.0 / 320.0), 1e-12);
  EXPECT_NEAR(yaw_on_a_curve(320.0), -std::atan(55.0 / 320.0), 1e-12);
  EXPECT_NEAR(yaw_on_a_curve(250.0, {.yaw_focal_px = 200.0}), -std::atan(50.0 / 200.0), 1e-12);
  EXPECT_NEAR(yaw_on_a_curve(250.0, {.yaw_rate_limit_rad_s = 0.1}), -0.1, 1e-12);
}

TEST(PidLaw, TheHigherItFliesTheSmallerTheOffsetThatMakesItYaw) {
  EXPECT_EQ(yaw_on_a_curve(230.0, {}, 0.5), 0.0);
  EXPECT_NEAR(yaw_on_a_curve(230.0, {}, 1.0), -std::atan(30.0 / 320.0), 1e-12);  // from 22.5 px on
}

TEST(PidLaw, AFrameThatComesTwiceTurnsNothing) {
  PidLaw law({});
  const Observation o = seen(255.0);
  law.follow(o, {0.1, 0.5, true});
  EXPECT_EQ(std::get<VelocityCommand>(law.follow(o, {0.1, 0.5, true})).yaw_rate_rad_s, 0.0);
}

TEST(PidLaw, HoldsTheHeight) {
  PidLaw law({});
  Observation low = seen(200.0), high = seen(200.0);
  low.estimate.height_m = 0.4;
  high.estimate.height_m = 0.6;
  EXPECT_GT(follow(law, low).up_m_s, 0.0);
  EXPECT_LT(follow(law, high).up_m_s, 0.0);
}

TEST(PidLaw, ResetForgetsIntegralAndDerivative) {
  PidLaw law({});
  follow(law, seen(300.0));
  law.reset();
  EXPECT_NEAR(follow(law, seen(240.0)).left_m_s, -0.152, 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
