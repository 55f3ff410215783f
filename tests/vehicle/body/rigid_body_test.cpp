#include "vehicle/body/rigid_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/attitude.h"

namespace lineservo::vehicle {
namespace {

BodyState at_height(double height_m) {
  BodyState state;
  state.p_WB.z() = height_m;
  return state;
}

TEST(RigidBody, FreeFallIsAParabola) {
  BodyState start = at_height(100.0);
  start.v_W << 1.0, -2.0, 3.0;
  RigidBody body({}, start);
  for (int i = 0; i < 2000; ++i) body.step({});
  const Eigen::Vector3d expected(2.0, -4.0, 100.0 + 3.0 * 2.0 - 0.5 * 9.81 * 4.0);
  EXPECT_NEAR((body.state().p_WB - expected).norm(), 0.0, 1e-9);
  EXPECT_NEAR(body.state().v_W.z(), 3.0 - 9.81 * 2.0, 1e-9);
}

TEST(RigidBody, AThrustOfItsWeightHoldsIt) {
  RigidBody body({}, at_height(1.0));
  const Wrench hover{{0, 0, 1.5 * 9.81}, {0, 0, 0}};
  for (int i = 0; i < 5000; ++i) body.step(hover);
  EXPECT_NEAR((body.state().p_WB - Eigen::Vector3d(0, 0, 1)).norm(), 0.0, 1e-9);
}

TEST(RigidBody, AConstantMomentSpinsItUpSteadily) {
  RigidBody body({}, at_height(50.0));
  const Wrench spin{{0, 0, 1.5 * 9.81}, {0, 0, 0.01}};
  for (int i = 0; i < 2000; ++i) body.step(spin);
  const double alpha = 0.01 / 0.055225;
  EXPECT_NEAR(body.state().w_B.z(), alpha * 2.0, 1e-6);
  EXPECT_NEAR(roll_pitch_yaw(body.state().q_WB).yaw_rad, 0.5 * alpha * 4.0, 1e-6);
}

TEST(RigidBody, TumblingFreelyItKeepsItsAngularMomentum) {
  BodyState start = at_height(100.0);
  start.w_B << 0.8, -0.5, 1.2;
  const AirframeParameters iris;
  RigidBody body(iris, start);
  const Eigen::Vector3d L0 = iris.inertia_kg_m2.cwiseProduct(start.w_B);
  for (int i = 0; i < 2000; ++i) body.step({});
  const Eigen::Vector3d L = body.state().q_WB * iris.inertia_kg_m2.cwiseProduct(body.state().w_B);
  EXPECT_NEAR((L - L0).norm() / L0.norm(), 0.0, 2e-3);
}

TEST(RigidBody, ItStandsOnItsGearAndDoesNotCreep) {
  RigidBody body({}, at_height(0.10));
  for (int i = 0; i < 3000; ++i) body.step({});
  EXPECT_NEAR(body.state().p_WB.z(), 0.10, 2e-3);
  EXPECT_NEAR(body.state().p_WB.head<2>().norm(), 0.0, 1e-5);
  EXPECT_NEAR(tilt_rad(body.state().q_WB), 0.0, 1e-4);
  EXPECT_TRUE(body.ground_contact().touches);
}

TEST(RigidBody, AFallIsFeltWithItsSpeed) {
  RigidBody body({}, at_height(0.10 + 0.2));
  double impact = 0.0;
  for (int i = 0; i < 1000; ++i) {
    body.step({});
    impact = std::max(impact, body.ground_contact().impact_speed_m_s);
  }
  EXPECT_NEAR(impact, std::sqrt(2 * 9.81 * 0.2), 0.05);
}

/// How far a sideways force, as a share of the weight, moves the standing body in half a second.
double slide_m(double share_of_weight) {
  const AirframeParameters iris;
  RigidBody body(iris, at_height(0.10));
  for (int i = 0; i < 500; ++i) body.step({});
  // Applied at the floor's height, so that it slides rather than tips.
  const double F = share_of_weight * iris.weight_N();
  for (int i = 0; i < 500; ++i) body.step({{F, 0, 0}, {0, -F * iris.gear_height_m, 0}});
  return body.state().p_WB.x();
}

TEST(RigidBody, FrictionHoldsUpToItsConeAndNotBeyond) {
  EXPECT_LT(slide_m(0.5), 0.01);
  EXPECT_GT(slide_m(1.2), 0.1);
}

}  // namespace
}  // namespace lineservo::vehicle
