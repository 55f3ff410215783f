#include "features/line/border_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "features/geometry/angles.h"
#include "tests/features/test_masks.h"

namespace lineservo::features {
namespace {

BorderPoint looking(double theta_deg, double length = 0.01) {
  const double theta_rad = radians(theta_deg);
  return {{length, theta_deg}, {std::cos(theta_rad), std::sin(theta_rad)}, theta_rad, length};
}

double off_deg(const BorderPoint& point, double theta_deg) {
  return std::abs(std::remainder(degrees(point.theta_rad) - theta_deg, 180.0));
}

std::vector<BorderPoint> every_way() {
  test::TestRandom random(3);
  std::vector<BorderPoint> points;
  for (int k = 0; k < 1000; ++k) points.push_back(looking(random.uniform(-90.0, 90.0)));
  return points;
}

TEST(BorderField, NearGivesEachPointWithinThirtyDegreesOnce) {
  const std::vector<BorderPoint> points = every_way();
  BorderField field;
  field.assign(points);
  for (const double theta_deg : {-90.0, -89.0, -60.0, 0.0, 31.0, 75.0, 90.0, 100.0}) {
    std::vector<int> given(points.size(), 0);
    for (const BorderPoint& point : field.near(radians(theta_deg))) {
      ++given[field.number(point)];
      EXPECT_LT(off_deg(point, theta_deg), 35.0);
      EXPECT_EQ(point.theta_rad, field.at(field.number(point)).theta_rad);
    }
    for (std::size_t i = 0; i < field.size(); ++i) {
      EXPECT_GE(given[i], int{off_deg(field.at(i), theta_deg) < 30.0}) << theta_deg;
      EXPECT_LE(given[i], 1) << theta_deg;
    }
  }
}

TEST(BorderField, TheStrongestDirectionIsThatOfTheMostFreeBorder) {
  BorderField field;
  field.assign({looking(20.2, 0.3), looking(20.8, 0.3), looking(-89.9, 0.2), looking(89.9, 0.2)});
  const auto peak = field.strongest_direction();
  ASSERT_TRUE(peak);
  EXPECT_NEAR(degrees(peak->theta_rad), 20.5, 1e-9);
  EXPECT_NEAR(peak->length, 0.6, 1e-12);
}

TEST(BorderField, WhatIsSpentOrDeferredDoesNotCount) {
  BorderField field;
  field.assign({looking(20.0, 0.5), looking(-89.9, 0.2), looking(89.9, 0.2)});
  for (const BorderPoint& point : field.near(radians(20.0)))
    if (off_deg(point, 20.0) < 1.0) field.set_use(field.number(point), PointUse::deferred);
  const auto peak = field.strongest_direction();
  ASSERT_TRUE(peak);
  EXPECT_NEAR(peak->length, 0.4, 1e-12);  // across the wrap
  EXPECT_LT(std::abs(std::remainder(degrees(peak->theta_rad) - 90.0, 180.0)), 1e-9);
  for (const BorderPoint& point : field.near(radians(90.0)))
    field.set_use(field.number(point), PointUse::spent);
  EXPECT_FALSE(field.strongest_direction());
  field.release_deferred();
  EXPECT_NEAR(field.strongest_direction()->length, 0.5, 1e-12);
}

TEST(BorderField, NoPointsNoDirection) {
  BorderField field;
  field.assign({});
  EXPECT_TRUE(field.near(0.3).empty());
  EXPECT_FALSE(field.strongest_direction());
}

}  // namespace
}  // namespace lineservo::features
