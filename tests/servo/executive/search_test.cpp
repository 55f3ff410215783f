#include "servo/executive/search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

using features::radians;

constexpr Time kTick = std::chrono::milliseconds(20);
constexpr Time kBegan = std::chrono::seconds(7);

/// A vehicle that does what the search says, and the way that it took.
struct Flown {
  std::vector<Eigen::Vector2d> way;
  double fastest_m_s = 0.0, took_s = 0.0, first_move_s = -1.0;

  double nearest_m(const Eigen::Vector2d& place) const {
    double nearest = 1e9;
    for (const auto& p : way) nearest = std::min(nearest, (p - place).norm());
    return nearest;
  }
};

Flown fly(Search search, Motion at) {
  Flown flown;
  Observation o;
  for (o.now = kBegan; !search.is_over(o.now) && o.now < kBegan + std::chrono::seconds(60); o.now += kTick) {
    o.estimate.odometry_now = at;
    const Eigen::Vector2d v = search.velocity_H_m_s(o);
    EXPECT_TRUE(v.allFinite());
    if (flown.first_move_s < 0.0 && v.norm() > 0.0) flown.first_move_s = seconds(o.now - kBegan);
    flown.fastest_m_s = std::max(flown.fastest_m_s, v.norm());
    at.translation_m += seconds(kTick) * (Eigen::Rotation2Dd(at.yaw_rad) * v);
    flown.way.push_back(at.translation_m);
  }
  flown.took_s = seconds(o.now - kBegan);
  return flown;
}

/// The line along +x of the odometry through the origin, seen last from `left_m` beside it.
LastLine line_seen_from(double left_m) {
  return {{{0.0, left_m}, 0.0}, left_m, 0.0};
}

constexpr double kReached_m = 0.05;

TEST(Search, WaitsFirst) {
  const SearchOptions options;
  const Flown flown = fly(Search(line_seen_from(0.1), 0, kBegan), {{0.3, 0.1}, 0.0});
  EXPECT_NEAR(flown.first_move_s, options.wait_s, seconds(kTick));
}

TEST(Search, GoesOverThePlaceToItsSideAndBack) {
  for (const double left_m : {-0.15, 0.15}) {
    const Flown flown = fly(Search(line_seen_from(left_m), 0, kBegan), {{0.3, left_m}, 0.0});
    EXPECT_LT(flown.nearest_m({0.0, 0.0}), kReached_m);
    EXPECT_LT(flown.nearest_m({0.0, left_m > 0.0 ? -0.2 : 0.2}), kReached_m) << "where the line lay";
    EXPECT_LT(flown.nearest_m({-0.3, 0.0}), kReached_m);
    EXPECT_GT(flown.nearest_m({0.0, left_m > 0.0 ? 0.4 : -0.4}), 0.2) << "the other side";
  }
}

TEST(Search, TheSecondTimeGoesAcrossAGap) {
  const Flown flown = fly(Search(line_seen_from(0.1), 1, kBegan), {{0.1, 0.1}, 0.0});
  EXPECT_LT(flown.nearest_m({0.6, 0.0}), kReached_m);
  EXPECT_LT(flown.nearest_m({-0.3, 0.0}), kReached_m);
}

// θ is the vehicle's heading less the line's.
TEST(Search, TurnsWithTheLineAndWithTheOdometry) {
  for (const double theta_deg : {-40.0, 0.0, 30.0}) {
    for (const double yaw_deg : {0.0, 75.0, 170.0}) {
      const double line_rad = radians(yaw_deg - theta_deg);
      const Eigen::Vector2d along(std::cos(line_rad), std::sin(line_rad)), left(-along.y(), along.x());
      const Eigen::Vector2d foot(2.0, -1.0);
      const LastLine last{{foot + 0.1 * left, radians(yaw_deg)}, 0.1, radians(theta_deg)};
      const Flown flown = fly(Search(last, 0, kBegan), {foot, radians(yaw_deg + 20.0)});
      EXPECT_LT(flown.nearest_m(foot - 0.2 * left), kReached_m) << theta_deg << ' ' << yaw_deg;
      EXPECT_LT(flown.nearest_m(foot - 0.3 * along), kReached_m) << theta_deg << ' ' << yaw_deg;
    }
  }
}

TEST(Search, KeepsToItsSpeedItsPlaceAndItsTime) {
  const SearchOptions options;
  for (const int attempt : {0, 1, 2}) {
    const Flown flown = fly(Search(line_seen_from(0.1), attempt, kBegan), {{0.2, 0.1}, 0.5});
    EXPECT_LE(flown.fastest_m_s, options.speed_m_s + 1e-9);
    for (const auto& p : flown.way) EXPECT_LT(p.norm(), options.ahead_m + kReached_m);
    EXPECT_LE(flown.took_s, options.limit_s + 2.0 * seconds(kTick));
  }
}

TEST(Search, GivesUpAPlaceThatItDoesNotReach) {
  Search search(line_seen_from(0.1), 0, kBegan);
  Observation o;
  o.estimate.odometry_now.translation_m << 5.0, 0.0;  // held there by the wind
  int ticks = 0;
  for (o.now = kBegan; !search.is_over(o.now); o.now += kTick, ++ticks) {
    ASSERT_LT(ticks, 1000);
    EXPECT_LE(search.velocity_H_m_s(o).norm(), SearchOptions{}.speed_m_s + 1e-9);
  }
  EXPECT_NEAR(seconds(o.now - kBegan), SearchOptions{}.limit_s, 2.0 * seconds(kTick));
}

TEST(Search, WithoutALineItWaitsAtRest) {
  const Flown flown = fly(Search(std::nullopt, 0, kBegan), {{0.3, 0.2}, 0.1});
  EXPECT_EQ(flown.fastest_m_s, 0.0);
  EXPECT_NEAR(flown.took_s, 2.0 * SearchOptions{}.wait_s, 2.0 * seconds(kTick));
}

}  // namespace
}  // namespace lineservo::servo
