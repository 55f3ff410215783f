#include "features/point/side_count.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

void paint(PackedMask& mask, int x0, int y0, int x1, int y1) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) mask.set(x, y);
}

/// A vertical stripe in columns 45…54 of 100×100; its middle is x = 49.5.
PackedMask stripe() {
  PackedMask mask(100, 100);
  paint(mask, 45, 0, 55, 100);
  return mask;
}

TEST(SideCount, CountsEitherSide) {
  const SideCount even = count_sides(stripe(), 49.5, 0.0);
  EXPECT_EQ(even.left, 500);
  EXPECT_EQ(even.right, 500);
  const SideCount on_a_column = count_sides(stripe(), 49.0, 0.0);
  EXPECT_EQ(on_a_column.left, 400);
  EXPECT_EQ(on_a_column.right, 500);
  const SideCount level = count_sides(stripe(), 24.5, kPi / 2.0);  // 25 rows above, 75 below
  EXPECT_EQ(level.left, 250);
  EXPECT_EQ(level.right, 750);
}

TEST(SideCount, TellsAnLFromANode) {
  EXPECT_EQ(l_turn(count_sides(stripe(), 49.5, 0.0)), LTurn::none);
  PackedMask left = stripe();
  paint(left, 0, 0, 45, 10);  // 450 more: 950 to 500
  EXPECT_EQ(l_turn(count_sides(left, 49.5, 0.0)), LTurn::left);
  PackedMask cross = left;
  paint(cross, 55, 0, 100, 10);
  EXPECT_EQ(l_turn(count_sides(cross, 49.5, 0.0)), LTurn::none);
  PackedMask right = stripe();
  paint(right, 55, 0, 100, 10);
  EXPECT_EQ(l_turn(count_sides(right, 49.5, 0.0)), LTurn::right);
}

TEST(SideCount, TheRatioMustBeExceeded) {
  EXPECT_EQ(l_turn({.left = 150, .right = 100}, 1.5), LTurn::none);
  EXPECT_EQ(l_turn({.left = 151, .right = 100}, 1.5), LTurn::left);
  EXPECT_EQ(l_turn({.left = 100, .right = 151}, 1.5), LTurn::right);
  EXPECT_EQ(l_turn({}, 1.5), LTurn::none);
  EXPECT_THROW(l_turn({}, 0.9), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::features
