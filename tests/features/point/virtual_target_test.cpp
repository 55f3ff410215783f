#include "features/point/virtual_target.h"

#include <gtest/gtest.h>

#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kCx = 79.5, kCy = 59.5;

/// A ray of half-width 3 px from the image centre, in 160×120.
void add_ray(PackedMask& mask, double direction_rad) {
  const double ux = -std::sin(direction_rad), uy = -std::cos(direction_rad);
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x) {
      const double dx = x - kCx, dy = y - kCy;
      if (dx * ux + dy * uy >= 0.0 && std::abs(dx * uy - dy * ux) <= 3.0) mask.set(x, y);
    }
}

PackedMask rays(std::initializer_list<double> directions_rad) {
  PackedMask mask(160, 120);
  for (const double direction : directions_rad) add_ray(mask, direction);
  return mask;
}

TEST(VirtualTarget, LiesOnTheRayAtTheArc) {
  for (const double direction : {0.0, 0.5, -1.0, 2.0, -3.0}) {
    const auto target = virtual_target(rays({direction}), direction);
    ASSERT_TRUE(target);
    EXPECT_NEAR(wrap_angle(target->direction_rad - direction), 0.0, radians(1.5)) << direction;
    EXPECT_NEAR(std::hypot(target->point_px.x - kCx, target->point_px.y - kCy), 27.5, 0.6);
  }
}

TEST(VirtualTarget, LeftIsPositive) {
  const auto target = virtual_target(rays({kPi / 2.0}), std::nullopt);
  ASSERT_TRUE(target);
  EXPECT_NEAR(target->direction_rad, kPi / 2.0, 1e-9);
  EXPECT_LT(target->point_px.x, kCx - 26.0);
  EXPECT_NEAR(target->point_px.y, kCy, 1e-9);
}

TEST(VirtualTarget, WithoutMemoryTheForwardCrossingCounts) {
  const auto target = virtual_target(rays({0.2, 0.2 + kPi}), std::nullopt);
  ASSERT_TRUE(target);
  EXPECT_NEAR(target->direction_rad, 0.2, radians(1.5));
}

TEST(VirtualTarget, RemembersWhereItWasGoing) {
  const PackedMask path = rays({radians(30.0), radians(-150.0)});
  const auto back = virtual_target(path, radians(-140.0));
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->direction_rad, radians(-150.0), radians(1.5));
}

TEST(VirtualTarget, SeesNothingOutsideItsArc) {
  const PackedMask path = rays({0.0});
  EXPECT_TRUE(virtual_target(path, radians(61.0)));
  EXPECT_FALSE(virtual_target(path, radians(75.0)));
  EXPECT_FALSE(virtual_target(PackedMask(160, 120), std::nullopt));
}

TEST(VirtualTarget, RefusesArcsThatAreNone) {
  const PackedMask path(160, 120);
  EXPECT_THROW(virtual_target(path, {}, {.inner_px = 0.0}), std::invalid_argument);
  EXPECT_THROW(virtual_target(path, {}, {.inner_px = 29.0}), std::invalid_argument);
  EXPECT_THROW(virtual_target(path, {}, {.half_angle_rad = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
