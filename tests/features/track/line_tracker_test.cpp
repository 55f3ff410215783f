#include "features/track/line_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

LineFeature line(double rho, double theta_rad) {
  LineFeature feature;
  feature.rho = rho;
  feature.theta_rad = theta_rad;
  feature.covariance = Eigen::Vector2d(1e-6, 1e-6).asDiagonal();
  return feature;
}

constexpr double kDt_s = 0.1;

TEST(LineTracker, TheFirstLineStartsTheTrack) {
  LineTracker tracker;
  EXPECT_FALSE(tracker.update(kDt_s, 0.5, {}).has_value());
  const std::vector<LineFeature> lines = {line(0.1, 0.2), line(-0.4, 0.2)};
  const auto tracked = tracker.update(kDt_s, 0.5, lines);
  ASSERT_TRUE(tracked.has_value());
  EXPECT_FALSE(tracked->predicted);
  EXPECT_NEAR(tracked->line.rho, 0.1, 1e-12);
  EXPECT_NEAR(tracked->line.theta_rad, 0.2, 1e-12);
}

TEST(LineTracker, SmoothsNoiseAndFollowsASteadyMotionWithoutLag) {
  LineTracker tracker({.offset_acceleration_m_s2 = 0.05, .angle_acceleration_rad_s2 = 0.05});
  std::mt19937 bits(3);
  double squares_raw = 0.0, squares_filtered = 0.0, sum = 0.0;
  constexpr int kFrames = 400, kSettled = 100;
  for (int k = 0; k < kFrames; ++k) {
    const double truth = -0.3 + 0.001 * k;
    const double noise = 0.008 * (std::generate_canonical<double, 32>(bits) - 0.5) * std::sqrt(12.0) / 2.0;
    LineFeature seen = line(truth + noise, 0.1);
    seen.covariance(0, 0) = 16e-6;
    const auto tracked = tracker.update(kDt_s, 0.5, std::vector{seen});
    ASSERT_TRUE(tracked.has_value());
    if (k < kSettled) continue;
    squares_raw += noise * noise;
    squares_filtered += std::pow(tracked->line.rho - truth, 2);
    sum += tracked->line.rho - truth;
  }
  EXPECT_LT(squares_filtered, 0.5 * squares_raw);
  EXPECT_GT(squares_filtered, 0.001 * squares_raw);
  EXPECT_NEAR(sum / (kFrames - kSettled), 0.0, 1e-3);
}

TEST(LineTracker, TheTwoFormsOfALineAreOne) {
  LineTracker tracker({.let_go_rad = 3.0});
  for (int k = 0; k < 20; ++k) {
    const double theta_rad = radians(85.0 + k);  // through 90°: the detector's branch flips
    const double axis_rad = theta_rad > kPi / 2 ? theta_rad - kPi : theta_rad;
    const double rho = theta_rad > kPi / 2 ? -0.2 : 0.2;
    const auto tracked = tracker.update(kDt_s, 0.5, std::vector{line(rho, axis_rad)});
    ASSERT_TRUE(tracked.has_value());
    EXPECT_FALSE(tracked->predicted) << k;
    EXPECT_NEAR(std::remainder(tracked->line.theta_rad - theta_rad, kPi), 0.0, 0.02) << k;
    EXPECT_LE(tracked->line.theta_rad, kPi / 2);
    EXPECT_GT(tracked->line.theta_rad, -kPi / 2);
    EXPECT_NEAR(std::abs(tracked->line.rho), 0.2, 0.01);
  }
}

TEST(LineTracker, AnOutlierIsGatedAndTheLinePredicted) {
  LineTracker tracker;
  for (int k = 0; k < 10; ++k) tracker.update(kDt_s, 0.5, std::vector{line(0.0, 0.0)});
  const auto tracked = tracker.update(kDt_s, 0.5, std::vector{line(0.6, 0.9)});
  ASSERT_TRUE(tracked.has_value());
  EXPECT_TRUE(tracked->predicted);
  EXPECT_NEAR(tracked->line.rho, 0.0, 1e-3);
}

TEST(LineTracker, TheGoalLineStaysTheGoalLineAmongParallels) {
  LineTracker tracker;
  for (int k = 0; k < 30; ++k) {
    // The vehicle moves to the right at 0.3 m/s: all three move left; the detector ranks another line first
    // each time.
    const double shift = -0.06 * k;
    std::vector<LineFeature> lines = {line(0.3 + shift, 0.0), line(0.9 + shift, 0.0), line(1.5 + shift, 0.0)};
    if (k > 0) std::rotate(lines.begin(), lines.begin() + k % 3, lines.end());
    const auto tracked = tracker.update(kDt_s, 0.5, lines);
    ASSERT_TRUE(tracked.has_value());
    EXPECT_NEAR(tracked->line.rho, 0.3 + shift, 0.02) << k;
  }
}

TEST(LineTracker, ClimbingDoesNotMoveTheLine) {
  LineTracker tracker;
  for (int k = 0; k < 20; ++k) {
    const double height_m = 0.5 + 0.05 * k;
    const auto tracked = tracker.update(kDt_s, height_m, std::vector{line(0.2 / height_m, 0.0)});
    ASSERT_TRUE(tracked.has_value());
    EXPECT_FALSE(tracked->predicted);
    EXPECT_NEAR(tracked->line.rho, 0.2 / height_m, 1e-6);
  }
}

TEST(LineTracker, AfterATurnTheLineAheadCounts) {
  LineTracker tracker;
  for (int k = 0; k <= 30; ++k) {
    const double turned_rad = radians(3.0 * k);
    std::vector<LineFeature> lines = {line(0.0, turned_rad), line(0.0, turned_rad - kPi / 2)};
    const auto tracked = tracker.update(kDt_s, 0.5, lines);
    ASSERT_TRUE(tracked.has_value());
    EXPECT_NEAR(tracked->line.theta_rad, k <= 20 ? turned_rad : turned_rad - kPi / 2, 0.05) << k;
  }
}

TEST(LineTracker, ALossIsBridgedAndThenForgotten) {
  LineTracker tracker({.memory_s = 0.35});
  for (int k = 0; k < 20; ++k) tracker.update(kDt_s, 0.5, std::vector{line(0.02 * k, 0.0)});
  for (int k = 1; k <= 3; ++k) {
    const auto tracked = tracker.update(kDt_s, 0.5, {});
    ASSERT_TRUE(tracked.has_value());
    EXPECT_TRUE(tracked->predicted);
    EXPECT_NEAR(tracked->line.rho, 0.02 * (19 + k), 0.01);  // goes on as it moved
  }
  EXPECT_FALSE(tracker.update(kDt_s, 0.5, {}).has_value());
  EXPECT_FALSE(tracker.expected(0.5).has_value());
}

TEST(LineTracker, RefusesOptionsThatMakeNoFilter) {
  EXPECT_THROW(LineTracker({.gate = 0.0}), std::invalid_argument);
  EXPECT_THROW(LineTracker({.memory_s = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
