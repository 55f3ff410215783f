#include "vehicle/floor/paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "features/geometry/angles.h"
#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using features::radians;

bool is_painted(const std::vector<PaintShape>& paint, const Vector2d& p_W) {
  return std::any_of(paint.begin(), paint.end(), [&](const PaintShape& shape) { return shape.paints(p_W); });
}

// Compares paint and a predicate on a grid about the hub; points within 0.2 mm of a border may go either way,
// so the grid is laid off the borders.
void expect_paint(const Layout& layout, const std::function<bool(const Vector2d&)>& expected) {
  const std::vector<PaintShape> paint = paint_of(layout);
  for (double x = -0.4003; x < 0.4; x += 0.01)
    for (double y = -0.4003; y < 0.4; y += 0.01)
      ASSERT_EQ(is_painted(paint, {x, y}), expected({x, y})) << x << ' ' << y;
}

constexpr double kHalf_m = 0.18;

bool within(double value) {
  return std::abs(value) <= kHalf_m;
}

TEST(Paint, ADeadEndStopsAtItsNode) {
  expect_paint(test::star({0.0}, 0.36), [](const Vector2d& p) { return p.x() >= 0.0 && within(p.y()); });
}

TEST(Paint, ACornerCoversTheWholeSquare) {
  expect_paint(test::star({0.0, radians(90.0)}, 0.36), [](const Vector2d& p) {
    return (p.x() >= -kHalf_m && within(p.y())) || (p.y() >= -kHalf_m && within(p.x()));
  });
}

TEST(Paint, AStubEndsInsideTheStripeThatRunsThrough) {
  expect_paint(test::star({0.0, radians(180.0), radians(-90.0)}, 0.36),
               [](const Vector2d& p) { return within(p.y()) || (p.y() <= 0.0 && within(p.x())); });
}

TEST(Paint, ACrossIsTwoStripes) {
  expect_paint(test::star({0.0, radians(90.0), radians(180.0), radians(-90.0)}, 0.36),
               [](const Vector2d& p) { return within(p.y()) || within(p.x()); });
}

TEST(Paint, ABendOf45DegreesIsFilledByADisc) {
  const Vector2d u(std::cos(radians(135.0)), std::sin(radians(135.0))), n(-u.y(), u.x());
  expect_paint(test::star({0.0, radians(135.0)}, 0.36), [&](const Vector2d& p) {
    return p.norm() <= kHalf_m || (p.x() >= 0.0 && within(p.y())) || (u.dot(p) >= 0.0 && within(n.dot(p)));
  });
}

TEST(Paint, APolylineJoinsItsPiecesAsNodesDo) {
  Layout layout;
  test::add_node(layout, "a", {-3.0, 0.0});
  test::add_node(layout, "b", {0.0, 3.0});
  layout.edges.push_back({0, 1, Curve::polyline({{-3.0, 0.0}, {0.0, 0.0}, {0.0, 3.0}})});
  expect_paint(layout, [](const Vector2d& p) {
    return (p.x() <= kHalf_m && within(p.y())) || (p.y() >= -kHalf_m && within(p.x()));
  });
}

TEST(Paint, AnArcOfThreeQuartersIsARingWithoutAQuarter) {
  Layout layout;
  test::add_node(layout, "a", {0.3, 0.0});
  test::add_node(layout, "b", {0.0, -0.3});
  layout.edges.push_back({0, 1, Curve::arc({0.3, 0.0}, {0.0, -0.3}, {0.0, 0.0}, true), 0.1});
  expect_paint(layout, [](const Vector2d& p) {
    return std::abs(p.norm() - 0.3) <= 0.05 && !(p.x() > 0.0 && p.y() < 0.0);
  });
}

TEST(Paint, BordersThatCoincideShareTheirId) {
  const std::vector<PaintShape> paint = paint_of(test::warehouse());
  int largest = 0;
  for (const PaintShape& shape : paint)
    for (const PaintBorder& border : shape.borders) largest = std::max(largest, border.id);
  // 11 stripes have 22 sides; ends inside the grid and the disc add theirs, far fewer than 4 × 49.
  EXPECT_GE(largest, 22);
  EXPECT_LT(largest, 120);
}

}  // namespace
}  // namespace lineservo::vehicle
