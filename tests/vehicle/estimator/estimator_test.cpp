#include "vehicle/estimator/estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {
namespace {

constexpr double kPeriod_s = seconds(kInertialPeriod);

/// Curves that start at rest, flown without tilting: the sensors do not mind.
BodyState curve(double t_s) {
  BodyState s;
  s.p_WB << 0.0, 0.0, 5.0 + 0.1 * std::sin(t_s) - 0.1 * t_s;
  s.v_W << 0.3 * std::sin(0.8 * t_s), 0.4 * std::cos(0.5 * t_s) - 0.4, 0.1 * std::cos(t_s) - 0.1;
  s.q_WB = quaternion({0.0, 0.0, 0.3 * t_s});
  s.w_B << 0.0, 0.0, 0.3;
  return s;
}

Eigen::Vector3d v_H(const BodyState& s) {
  Eigen::Vector3d v = s.v_W;
  v.head<2>() = turned(v.head<2>(), -roll_pitch_yaw(s.q_WB).yaw_rad);
  return v;
}

struct Errors {
  double v_sigma = 0.0, climb_sigma = 0.0, height_sigma = 0.0;
};

/// Over `flights` seeds, `duration_s` each, after 5 s.
template <typename Motion>
Errors measured(const SensorParameters& p, int flights, double duration_s, Motion motion) {
  double v2 = 0.0, climb2 = 0.0, height2 = 0.0;
  int count = 0;
  for (int seed = 0; seed < flights; ++seed) {
    Sensors sensors(p, static_cast<std::uint64_t>(seed), motion(0.0));
    Estimator estimator(p, sensors.sample(Time(0), motion(0.0)));
    for (int i = 1; i * kPeriod_s < duration_s; ++i) {
      const BodyState truth = motion(i * kPeriod_s);
      estimator.update(sensors.sample(i * kInertialPeriod, truth));
      if (i * kPeriod_s < 5.0) continue;
      const Eigen::Vector3d e = estimator.estimate().v_H_m_s - v_H(truth);
      v2 += 0.5 * e.head<2>().squaredNorm();
      climb2 += e.z() * e.z();
      height2 += std::pow(estimator.estimate().height_m - truth.p_WB.z(), 2);
      ++count;
    }
  }
  return {std::sqrt(v2 / count), std::sqrt(climb2 / count), std::sqrt(height2 / count)};
}

BodyState hover(double) {
  BodyState s;
  s.p_WB.z() = 0.5;
  return s;
}

TEST(Estimator, InHoverTheVelocityIsGoodToOneCentimetreASecond) {
  const Errors e = measured({}, 200, 15.0, hover);
  EXPECT_LT(e.v_sigma, 0.0130);
  EXPECT_GT(e.v_sigma, 0.0100);  // the flow's own bias cannot be seen from inside
  EXPECT_LT(e.height_sigma, 0.002);
  EXPECT_LT(e.climb_sigma, 0.005);
}

TEST(Estimator, WithoutTheFlowsBiasWhatIsLeftIsNoise) {
  SensorParameters p;
  p.flow_bias_m_s = 0.0;
  const Errors e = measured(p, 200, 15.0, hover);
  EXPECT_LT(e.v_sigma, 0.0085);
  EXPECT_GT(e.v_sigma, 0.004);
}

// Height, climb and a white acceleration of the density q, the height measured with the density r: the Kalman
// filter has ω = (q/r)^¼ and the variances √2 ω r and √2 ω³ r. The bias that it learns adds a little.
TEST(Estimator, ANoisyRangeIsFilteredAsWellAsTheAccelerometerAllows) {
  SensorParameters p;
  p.range_sigma_m = 0.02;
  const Errors e = measured(p, 200, 15.0, hover);
  const double r = 0.02 * 0.02 * seconds(kRangePeriod), q = 0.05 * 0.05 * kPeriod_s;
  const double w = std::pow(q / r, 0.25);
  EXPECT_NEAR(e.height_sigma, std::sqrt(std::sqrt(2.0) * w * r), 0.15 * e.height_sigma);
  EXPECT_NEAR(e.climb_sigma, std::sqrt(std::sqrt(2.0) * w * w * w * r), 0.25 * e.climb_sigma);
}

TEST(Estimator, IdealSensorsGiveTheMotionBack) {
  const Errors e = measured(SensorParameters::ideal(), 1, 12.0, curve);
  EXPECT_LT(e.v_sigma, 1e-3);
  EXPECT_LT(e.climb_sigma, 1e-3);
  EXPECT_LT(e.height_sigma, 1e-3);
}

TEST(Estimator, LearnsTheBiasOfTheAcceleration) {
  SensorParameters p = SensorParameters::ideal();
  p.accelerometer_bias_m_s2 = 0.2;
  Sensors sensors(p, 4, hover(0));
  Estimator estimator(p, sensors.sample(Time(0), hover(0)));
  for (int i = 1; i < 4000; ++i) estimator.update(sensors.sample(i * kInertialPeriod, hover(0)));
  EXPECT_LT(estimator.estimate().a_H_m_s2.norm(), 0.01);
  EXPECT_LT(estimator.estimate().v_H_m_s.norm(), 0.002);
}

TEST(Estimator, YawIsTheIntegralOfTheGyroAndCountsOn) {
  Sensors sensors(SensorParameters::ideal(), 4, curve(0));
  Estimator estimator(SensorParameters::ideal(), sensors.sample(Time(0), curve(0)));
  for (int i = 1; i <= 4000; ++i) {
    estimator.update(sensors.sample(i * kInertialPeriod, curve(i * kPeriod_s)));
  }
  EXPECT_NEAR(estimator.estimate().yaw_rad, 0.3 * 20.0, 1e-9);
}

TEST(Estimator, IsFiniteWhateverTheFirstReadingsSay) {
  const double nan = std::nan("");
  SensorReadings first;
  first.gyro_B_rad_s.setConstant(nan);
  first.specific_force_B_m_s2.setConstant(nan);
  first.roll_rad = first.pitch_rad = nan;
  first.range_m = nan;
  first.flow_v_H_m_s = Eigen::Vector2d(nan, nan);
  const SensorParameters parameters;
  Estimator estimator(parameters, first);
  Sensors sensors(parameters, 1, hover(0.0));
  for (int i = 1; i < 2000; ++i) {
    estimator.update(sensors.sample(i * kInertialPeriod, hover(0.0)));
    const Estimate& e = estimator.estimate();
    ASSERT_TRUE(e.v_H_m_s.allFinite() && std::isfinite(e.height_m) && std::isfinite(e.yaw_rad)) << i;
  }
  EXPECT_NEAR(estimator.estimate().height_m, 0.5, 0.02);
}

}  // namespace
}  // namespace lineservo::vehicle
