#include "vehicle/quadrotor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "vehicle/attitude.h"

namespace lineservo::vehicle {
namespace {

Quadrotor made(const SensorParameters& sensors, std::uint64_t seed = 1, double wind_m_s = 0.0,
               const AutopilotOptions& options = {}) {
  return {{}, options, sensors, std::make_unique<ConstantWind>(wind_m_s, 0.7), seed, {1.0, 2.0, 0.5}};
}

VelocitySetpoint velocity(double x, double y, double z, double yaw_rate = 0.0) {
  VelocitySetpoint s;
  s.v_H_m_s << x, y, z;
  s.yaw_rate_rad_s = yaw_rate;
  return s;
}

/// Goes on for this long without a word.
void wait(Quadrotor& q, double duration_s) {
  for (long i = std::lround(duration_s * 1e3); i > 0; --i) q.step();
}

/// Commands 50 times a second with paint in sight; calls `watch` after every step.
template <typename Watch>
void fly(Quadrotor& q, const Setpoint& setpoint, double duration_s, Watch watch) {
  const long steps = std::lround(duration_s * 1e3);
  for (long i = 0; i < steps; ++i) {
    if (i % 20 == 0) {
      q.command(setpoint, q.now());
      q.paint_sighted(q.now());
    }
    q.step();
    watch();
  }
}
void fly(Quadrotor& q, const Setpoint& setpoint, double duration_s) {
  fly(q, setpoint, duration_s, [] {});
}

void take_off(Quadrotor& q) {
  fly(q, velocity(0, 0, 0.4), 1.2);
  fly(q, velocity(0, 0, 0), 2.0);
}

Eigen::Vector3d true_v_H(const Quadrotor& q) {
  Eigen::Vector3d v = q.truth().v_W;
  v.head<2>() = turned(v.head<2>(), -roll_pitch_yaw(q.truth().q_WB).yaw_rad);
  return v;
}

TEST(Quadrotor, StandsOnTheFloorUntilCommanded) {
  Quadrotor q = made({});
  wait(q, 3.0);
  EXPECT_EQ(q.mode(), AutopilotMode::idle);
  EXPECT_NEAR((q.truth().p_WB - Eigen::Vector3d(1.0, 2.0, 0.10)).norm(), 0.0, 2e-3);
  EXPECT_NEAR(roll_pitch_yaw(q.truth().q_WB).yaw_rad, 0.5, 1e-4);
  EXPECT_EQ(q.now(), std::chrono::seconds(3));
}

TEST(Quadrotor, TakesOffStraightUpEvenAfterALongWait) {
  Quadrotor q = made(SensorParameters::ideal());
  wait(q, 5.0);
  take_off(q);
  EXPECT_EQ(q.mode(), AutopilotMode::tracking);
  EXPECT_NEAR(q.truth().p_WB.x(), 1.0, 0.01);
  EXPECT_NEAR(q.truth().p_WB.y(), 2.0, 0.01);
  EXPECT_NEAR(q.truth().p_WB.z(), 0.10 + 0.4 * 1.2, 0.08);
  EXPECT_LT(q.truth().v_W.norm(), 0.01);
}

TEST(Quadrotor, AVelocityStepRisesInAThirdOfASecondWithoutOvershoot) {
  Quadrotor q = made(SensorParameters::ideal());
  take_off(q);
  const double height_m = q.truth().p_WB.z();
  double at_10 = 0.0, at_90 = 0.0, most = 0.0, t_s = 0.0;
  fly(q, velocity(0.5, 0, 0), 4.0, [&] {
    t_s += 1e-3;
    const double v = true_v_H(q).x();
    if (at_10 == 0.0 && v > 0.05) at_10 = t_s;
    if (at_90 == 0.0 && v > 0.45) at_90 = t_s;
    most = std::max(most, v);
    EXPECT_NEAR(q.truth().p_WB.z(), height_m, 0.03);
  });
  EXPECT_GT(at_90, 0.0);
  EXPECT_LT(at_90 - at_10, 0.35);
  EXPECT_GT(at_90 - at_10, 0.15);
  EXPECT_LT(most, 0.525);
  EXPECT_NEAR(true_v_H(q).x(), 0.5, 0.005);
}

TEST(Quadrotor, TurningItGoesWhereItsNosePoints) {
  Quadrotor q = made(SensorParameters::ideal());
  take_off(q);
  fly(q, velocity(0.5, 0, 0), 2.0);
  fly(q, velocity(0.5, 0, 0, 0.8), 1.0);
  const double yaw_before = q.estimate().yaw_rad;
  fly(q, velocity(0.5, 0, 0, 0.8), 2.0, [&] { EXPECT_LT(std::abs(true_v_H(q).y()), 0.03); });
  EXPECT_NEAR(q.estimate().yaw_rad - yaw_before, 1.6, 0.01);
  EXPECT_NEAR(true_v_H(q).x(), 0.5, 0.02);
}

TEST(Quadrotor, AnAttitudeStepSettlesAndHoldsItsHeight) {
  Quadrotor q = made(SensorParameters::ideal());
  take_off(q);
  AttitudeSetpoint tilt;
  tilt.pitch_rad = 0.1;
  tilt.height_m = 0.5;
  double most = 0.0;
  fly(q, tilt, 0.4, [&] { most = std::max(most, roll_pitch_yaw(q.truth().q_WB).pitch_rad); });
  EXPECT_NEAR(roll_pitch_yaw(q.truth().q_WB).pitch_rad, 0.1, 0.003);
  EXPECT_LT(most, 0.105);
  tilt.pitch_rad = 0.0;
  fly(q, tilt, 3.0);
  EXPECT_NEAR(q.truth().p_WB.z(), 0.5, 0.01);
}

TEST(Quadrotor, AtTheSpeedLimitATiltPushesNoFurther) {
  AutopilotOptions options;
  options.limits.max_horizontal_speed_m_s = 0.8;
  Quadrotor q = made(SensorParameters::ideal(), 1, 0.0, options);
  take_off(q);
  AttitudeSetpoint tilt;
  tilt.pitch_rad = 0.25;
  fly(q, tilt, 6.0, [&] { EXPECT_LT(true_v_H(q).x(), 0.85); });
  EXPECT_GT(true_v_H(q).x(), 0.5);
}

TEST(Quadrotor, ASteadyWindLeavesNoVelocity) {
  Quadrotor q = made(SensorParameters::ideal(), 1, 1.5);
  take_off(q);
  fly(q, velocity(0, 0, 0), 8.0);
  EXPECT_LT(q.truth().v_W.norm(), 0.005);
}

// Hover takes the thrust of the weight, whatever the autopilot was made for; its integral finds the rest.
TEST(Quadrotor, HoversWithALoadAndAWeakMotor) {
  AirframeParameters burdened;
  burdened.load_factor = 1.1;
  burdened.thrust_factors[0] = 0.85;
  Quadrotor q(burdened, {}, SensorParameters::ideal(), nullptr, 1, {1.0, 2.0, 0.5});
  take_off(q);
  fly(q, velocity(0, 0, 0), 8.0);
  EXPECT_LT(q.truth().v_W.norm(), 0.01);
  EXPECT_LT(q.truth().w_B.norm(), 0.01);
  EXPECT_GT(q.truth().p_WB.z(), 0.3);
}

TEST(Quadrotor, APayloadItDoesNotKnowOfCostsNoClimbRate) {
  AutopilotOptions options;
  options.believed_mass_ratio = 1.0 / 1.1;
  Quadrotor q = made(SensorParameters::ideal(), 1, 0.0, options);
  take_off(q);
  fly(q, velocity(0, 0, 0), 3.0);
  EXPECT_LT(std::abs(q.truth().v_W.z()), 0.005);
  EXPECT_GT(q.truth().p_WB.z(), 0.3);
}

/// A palm-sized quadrotor, 24 times lighter, with slower motors.
AirframeParameters palm_sized() {
  using Spin = RotorPlacement::Spin;
  constexpr double kArm_m = 0.044;
  AirframeParameters a;
  a.mass_kg = 0.063;
  a.inertia_kg_m2 << 5.829e-5, 7.169e-5, 1e-4;
  a.rotors = {{{kArm_m, -kArm_m, Spin::counter_clockwise},
               {-kArm_m, kArm_m, Spin::counter_clockwise},
               {kArm_m, kArm_m, Spin::clockwise},
               {-kArm_m, -kArm_m, Spin::clockwise}}};
  a.max_rotor_speed_rad_s = 2000.0;
  a.thrust_coefficient_N_s2 = 2.0 * a.weight_N() / (4.0 * 2000.0 * 2000.0);
  a.moment_coefficient_m = 0.01;
  a.motor_lag_up_s = a.motor_lag_down_s = 0.02;
  a.rotor_drag_N_per_rad_s_m_s = 2e-6;
  a.rotor_radius_m = 0.033;
  a.body_drag_area_m2 = 0.003;
  a.gear_height_m = 0.03;
  a.collision_half_extents_m << 0.06, 0.06, 0.02;
  return a;
}

TEST(Quadrotor, AnotherVehicleFliesOnGainsFromItsOwnParameters) {
  Quadrotor q(palm_sized(), {}, SensorParameters::ideal(), nullptr, 1, {});
  take_off(q);
  double most = 0.0;
  fly(q, velocity(0.5, 0, 0, 0.5), 4.0, [&] { most = std::max(most, true_v_H(q).x()); });
  EXPECT_NEAR(true_v_H(q).x(), 0.5, 0.01);
  EXPECT_LT(most, 0.53);
  EXPECT_NEAR(q.truth().w_B.z(), 0.5, 0.01);
  q.command(LandSetpoint{}, q.now());
  wait(q, 5.0);
  EXPECT_EQ(q.mode(), AutopilotMode::landed);
  EXPECT_FALSE(q.crashed());
}

TEST(Quadrotor, WithTheNoiseOfTheSensorsItHoversQuietly) {
  SensorParameters p;
  p.flow_bias_m_s = 0.0;  // what the vehicle cannot know it cannot correct
  int quiet = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Quadrotor q = made(p, seed);
    take_off(q);
    fly(q, velocity(0, 0, 0), 3.0);
    fly(q, velocity(0, 0, 0), 10.0, [&] {
      ++all;
      quiet += true_v_H(q).head<2>().norm() < 0.03;
      EXPECT_LT(tilt_rad(q.truth().q_WB), 0.02);
    });
  }
  EXPECT_GT(quiet, 0.97 * all);
}

TEST(Quadrotor, WithoutCommandsItBrakesThenLandsThenStops) {
  Quadrotor q = made({});
  take_off(q);
  fly(q, velocity(0.5, 0, 0), 1.5);
  wait(q, 0.25);
  EXPECT_EQ(q.mode(), AutopilotMode::tracking);  // the last command came 20 ms before and holds 300 ms
  wait(q, 0.1);
  EXPECT_EQ(q.mode(), AutopilotMode::braking);
  const double height_m = q.truth().p_WB.z();
  wait(q, 4.8);
  EXPECT_EQ(q.mode(), AutopilotMode::braking);
  EXPECT_LT(q.truth().v_W.norm(), 0.06);
  EXPECT_NEAR(q.truth().p_WB.z(), height_m, 0.03);
  wait(q, 0.3);
  EXPECT_EQ(q.mode(), AutopilotMode::landing);
  wait(q, 5.0);
  EXPECT_EQ(q.mode(), AutopilotMode::landed);
  EXPECT_NEAR(q.truth().p_WB.z(), 0.10, 2e-3);
  EXPECT_FALSE(q.crashed());
}

TEST(Quadrotor, LandsOnCommandAndTakesOffAgain) {
  Quadrotor q = made({});
  take_off(q);
  q.command(LandSetpoint{}, q.now());
  wait(q, 5.0);
  EXPECT_EQ(q.mode(), AutopilotMode::landed);
  EXPECT_FALSE(q.crashed());
  take_off(q);
  EXPECT_EQ(q.mode(), AutopilotMode::tracking);
  EXPECT_GT(q.truth().p_WB.z(), 0.4);
}

TEST(Quadrotor, NotANumberNeverReachesTheMotors) {
  Quadrotor q = made({});
  take_off(q);
  const VelocitySetpoint bad = velocity(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  for (int i = 0; i < 500; ++i) {
    q.command(bad, q.now());
    q.step();
    ASSERT_TRUE(q.truth().p_WB.allFinite());
  }
  EXPECT_EQ(q.mode(), AutopilotMode::braking);  // as if nothing had been said
}

TEST(Quadrotor, StopsWhenItHasTravelledTooFarWithoutPaint) {
  Quadrotor q = made(SensorParameters::ideal());
  take_off(q);
  const Eigen::Vector3d start = q.truth().p_WB;
  const auto fly_blind = [&](double duration_s) {
    for (long i = 0; i < std::lround(duration_s * 1e3); ++i) {
      q.command(velocity(0.5, 0, 0), q.now());
      q.step();
    }
  };
  fly_blind(1.8);
  EXPECT_EQ(q.mode(), AutopilotMode::tracking);
  fly_blind(2.2);
  EXPECT_EQ(q.mode(), AutopilotMode::braking);
  EXPECT_GT((q.truth().p_WB - start).norm(), 1.0);
  EXPECT_LT((q.truth().p_WB - start).norm(), 1.3);
  fly(q, velocity(0.5, 0, 0), 1.0);
  EXPECT_EQ(q.mode(), AutopilotMode::tracking);
}

TEST(Quadrotor, StaysBelowItsGreatestHeight) {
  AutopilotOptions options;
  options.limits.max_height_m = 1.0;
  Quadrotor q = made(SensorParameters::ideal(), 1, 0.0, options);
  fly(q, velocity(0, 0, 0.8), 6.0, [&] { EXPECT_LT(q.truth().p_WB.z(), 1.05); });
  EXPECT_GT(q.truth().p_WB.z(), 0.9);
}

TEST(Quadrotor, AGustThatThrowsItDownIsACrash) {
  /// Air that falls on it after two seconds.
  class DownBurst : public Wind {
   public:
    Eigen::Vector3d velocity_W(Time t, const Eigen::Vector3d&) override {
      return {0.0, 0.0, t > std::chrono::seconds(4) ? -60.0 : 0.0};
    }
  };
  Quadrotor q({}, {}, SensorParameters::ideal(), std::make_unique<DownBurst>(), 1, {});
  take_off(q);
  fly(q, velocity(0, 0, 0), 3.0);
  EXPECT_TRUE(q.crashed());
  fly(q, velocity(0, 0, 0.5), 2.0);
  EXPECT_LT(q.truth().p_WB.z(), 0.2);  // its motors stay off
}

TEST(Quadrotor, TheEstimateForATimeIsTheOneOfThen) {
  Quadrotor q = made({});
  take_off(q);
  const Estimate then = q.estimate();
  fly(q, velocity(0.3, 0, 0), 0.5);
  EXPECT_EQ(q.estimate_at(then.stamp).v_H_m_s, then.v_H_m_s);
  EXPECT_EQ(q.estimate_at(q.now()).stamp, q.estimate().stamp);
}

TEST(Quadrotor, BadParametersAreRefused) {
  AirframeParameters heavy;
  heavy.mass_kg = 30.0;
  EXPECT_THROW(Quadrotor(heavy, {}, {}, nullptr, 1, {}), std::invalid_argument);
  EXPECT_THROW(Quadrotor({}, {}, {}, nullptr, 1, {std::nan(""), 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(ConstantWind(-1.0), std::invalid_argument);
}

/// FNV-1a over the state in micrometres, microradians and so on: rounding keeps the last bits of another
/// mathematics library from changing it.
class StateHash {
 public:
  void add(const BodyState& s) {
    for (int i = 0; i < 3; ++i) add(s.p_WB[i]), add(s.v_W[i]), add(s.w_B[i]);
    for (int i = 0; i < 4; ++i) add(s.q_WB.coeffs()[i]);
  }
  std::uint64_t value() const { return hash_; }

 private:
  void add(double x) {
    hash_ ^= static_cast<std::uint64_t>(std::llround(x * 1e6));
    hash_ *= 0x100000001b3ULL;
  }
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::uint64_t hash_of_five_seconds(std::uint64_t seed) {
  Quadrotor q = made({}, seed, 1.0);
  StateHash hash;
  const auto watch = [&] { hash.add(q.truth()); };
  fly(q, velocity(0, 0, 0.4), 1.2, watch);
  fly(q, velocity(0.4, -0.1, 0, 0.5), 2.0, watch);
  AttitudeSetpoint tilt;
  tilt.roll_rad = 0.05;
  fly(q, tilt, 1.0, watch);
  for (int i = 0; i < 800; ++i) q.step(), watch();
  return hash.value();
}

TEST(Quadrotor, TheSameSeedFliesTheSameFlightBitForBit) {
  Quadrotor a = made({}, 7, 1.0), b = made({}, 7, 1.0), c = made({}, 8, 1.0);
  for (Quadrotor* q : {&a, &b, &c}) take_off(*q);
  EXPECT_EQ(a.truth().p_WB, b.truth().p_WB);
  EXPECT_EQ(a.truth().q_WB.coeffs(), b.truth().q_WB.coeffs());
  EXPECT_EQ(a.estimate().v_H_m_s, b.estimate().v_H_m_s);
  EXPECT_NE(a.truth().p_WB, c.truth().p_WB);
}

TEST(Quadrotor, TheFlightThatWasRecordedOnceIsStillFlown) {
  EXPECT_EQ(hash_of_five_seconds(1), 6283026084482339915ULL);
}

}  // namespace
}  // namespace lineservo::vehicle
