#include "vehicle/sensors/sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lineservo::vehicle {
namespace {

struct Moments {
  double mean = 0.0, sigma = 0.0;
};

Moments moments(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

BodyState hovering() {
  BodyState state;
  state.p_WB.z() = 0.5;
  return state;
}

template <typename Read>
std::vector<double> sampled(Sensors sensors, const BodyState& truth, int count, Read read) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) read(sensors.sample(i * kInertialPeriod, truth), values);
  return values;
}

double degrees(double rad) {
  return rad / SensorParameters::kDegree;
}

TEST(Sensors, WhiteNoiseHasItsSigma) {
  const Sensors sensors({}, 5, hovering());
  const auto gyro = sampled(sensors, hovering(), 20000, [](const SensorReadings& r, std::vector<double>& v) {
    v.push_back(r.gyro_B_rad_s.y());
  });
  EXPECT_NEAR(degrees(moments(gyro).sigma), 0.1, 0.002);
  const auto acc = sampled(sensors, hovering(), 20000, [](const SensorReadings& r, std::vector<double>& v) {
    v.push_back(r.specific_force_B_m_s2.z() - 9.81);
  });
  EXPECT_NEAR(moments(acc).sigma, 0.05, 0.001);
  EXPECT_LT(std::abs(moments(acc).mean), 0.2);
  const auto range = sampled(sensors, hovering(), 40000, [](const SensorReadings& r, std::vector<double>& v) {
    if (r.range_m) v.push_back(*r.range_m);
  });
  EXPECT_EQ(range.size(), 10000u);  // 50 Hz
  EXPECT_NEAR(moments(range).sigma, 0.005, 1e-4);
  EXPECT_NEAR(moments(range).mean, 0.5, 2e-4);
}

TEST(Sensors, TheFlowAnswersTwentyTimesASecondInTheHeadingFrame) {
  BodyState truth = hovering();
  truth.q_WB = quaternion({0.0, 0.0, 1.2});
  truth.v_W << std::cos(1.2), std::sin(1.2), 0.0;
  SensorParameters p;
  p.flow_bias_m_s = 0.0;
  const auto flow = sampled(Sensors(p, 5, truth), truth, 40000, [](const SensorReadings& r, auto& v) {
    if (r.flow_v_H_m_s) v.push_back(r.flow_v_H_m_s->x());
  });
  EXPECT_EQ(flow.size(), 4000u);
  EXPECT_NEAR(moments(flow).mean, 1.0, 0.002);
  EXPECT_NEAR(moments(flow).sigma, 0.03, 0.001);
}

TEST(Sensors, BiasesAreDrawnForEachFlight) {
  SensorParameters p;
  p.gyro_sigma_rad_s = p.accelerometer_sigma_m_s2 = p.attitude_sigma_rad = 0.0;
  std::vector<double> gyro, acc;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const SensorReadings r = Sensors(p, seed, hovering()).sample(Time(0), hovering());
    gyro.push_back(degrees(r.gyro_B_rad_s.x()));
    acc.push_back(r.specific_force_B_m_s2.x());
  }
  EXPECT_NEAR(moments(gyro).mean, 0.0, 0.003);
  EXPECT_NEAR(moments(gyro).sigma, 0.05, 0.003);
  EXPECT_NEAR(moments(acc).sigma, 0.05, 0.003);
}

TEST(Sensors, TheAttitudeErrorIsStationaryAndForgetsInTenSeconds) {
  double at_start = 0.0, later = 0.0, product = 0.0;
  constexpr int kFlights = 2000;
  for (std::uint64_t seed = 0; seed < kFlights; ++seed) {
    Random random(seed);
    GaussMarkov error(0.2, 10.0, 0.5, random);
    const double first = error.value();
    for (int i = 0; i < 20; ++i) error.step(random);
    at_start += first * first / kFlights;
    later += error.value() * error.value() / kFlights;
    product += first * error.value() / kFlights;
  }
  EXPECT_NEAR(std::sqrt(at_start), 0.2, 0.008);
  EXPECT_NEAR(std::sqrt(later), 0.2, 0.008);
  EXPECT_NEAR(product / at_start, std::exp(-1.0), 0.06);
}

TEST(Sensors, IdealSensorsTellTheTruth) {
  BodyState before = hovering();
  before.q_WB = quaternion({0.1, -0.2, 0.7});
  before.w_B << 0.1, 0.2, 0.3;
  BodyState truth = before;
  truth.v_W << 0.01, 0.0, 0.02;  // over 5 ms
  Sensors sensors(SensorParameters::ideal(), 1, before);
  const SensorReadings r = sensors.sample(Time(0), truth);
  EXPECT_EQ(r.gyro_B_rad_s, truth.w_B);
  EXPECT_NEAR((truth.q_WB * r.specific_force_B_m_s2 - Eigen::Vector3d(2.0, 0.0, 4.0 + 9.81)).norm(), 0.0,
              1e-9);
  EXPECT_NEAR(r.roll_rad, 0.1, 1e-12);
  EXPECT_NEAR(r.pitch_rad, -0.2, 1e-12);
  EXPECT_NEAR(*r.range_m * std::cos(0.1) * std::cos(0.2), 0.5, 1e-12);
}

TEST(Sensors, SilencingOneSourceLeavesTheOthersAsTheyWere) {
  SensorParameters quiet;
  quiet.flow_sigma_m_s = quiet.range_sigma_m = quiet.accelerometer_sigma_m_s2 = 0.0;
  Sensors with({}, 9, hovering()), without(quiet, 9, hovering());
  for (int i = 0; i < 50; ++i) {
    const SensorReadings a = with.sample(i * kInertialPeriod, hovering());
    const SensorReadings b = without.sample(i * kInertialPeriod, hovering());
    EXPECT_EQ(a.gyro_B_rad_s, b.gyro_B_rad_s);
    EXPECT_EQ(a.roll_rad, b.roll_rad);
  }
}

TEST(Sensors, BadParametersAreRefused) {
  SensorParameters bad;
  bad.range_sigma_m = -1.0;
  EXPECT_THROW(Sensors(bad, 1, hovering()), std::invalid_argument);
}

// e^(−t/τ) of its start, whichever way it points.
TEST(Sensors, TheVelocitysBiasAtPowerOnDiesAway) {
  SensorParameters p = SensorParameters::ideal();
  p.flow_bias_start_m_s = 0.03;
  Sensors sensors(p, 5, hovering()), other(p, 6, hovering());
  const Eigen::Vector2d start = *sensors.sample(Time(0), hovering()).flow_v_H_m_s;
  const Eigen::Vector2d later = *sensors.sample(std::chrono::seconds(60), hovering()).flow_v_H_m_s;
  EXPECT_NEAR(start.norm(), 0.03, 1e-12);
  EXPECT_NEAR((later - std::exp(-1.0) * start).norm(), 0.0, 1e-12);
  EXPECT_GT((start - *other.sample(Time(0), hovering()).flow_v_H_m_s).norm(), 1e-4);
}

}  // namespace
}  // namespace lineservo::vehicle
