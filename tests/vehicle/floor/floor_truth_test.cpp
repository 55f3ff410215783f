#include "vehicle/floor/floor_truth.h"

#include <gtest/gtest.h>

#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::vehicle {
namespace {

TEST(FloorTruth, FindsTheNearestEdgeAndWhereOnIt) {
  const Layout layout = test::bend(0.1, 1.5);
  const NearestEdge straight = nearest_edge(layout, {0.4, -0.2});
  EXPECT_EQ(straight.edge, 0U);
  EXPECT_NEAR(straight.projection.arc_length_m, 0.4, 1e-12);
  EXPECT_NEAR(straight.projection.signed_offset_m, -0.2, 1e-12);
  const NearestEdge arc = nearest_edge(layout, {1.0 + 0.5, 1.5 - 1.0});
  EXPECT_EQ(arc.edge, 1U);
  EXPECT_NEAR(arc.projection.signed_offset_m, 1.5 - std::hypot(0.5, 1.0), 1e-12);
}

TEST(FloorTruth, DistanceToCentrelineAndPaint) {
  const Layout layout = test::warehouse();
  const Eigen::Vector2d between(2.4, 0.6 + 0.5);
  EXPECT_NEAR(distance_to_centreline_m(layout, between), 0.5, 1e-12);
  EXPECT_NEAR(distance_to_paint_m(layout, between), 0.5 - 0.18, 1e-12);
  EXPECT_EQ(distance_to_paint_m(layout, {2.4, 0.6 + 0.17}), 0.0);
  EXPECT_NEAR(distance_to_paint_m(layout, {2.4, 0.6 + 0.19}), 0.01, 1e-12);
}

TEST(FloorTruth, MarkersArePaint) {
  Layout layout = test::single_line({0.0, 0.0}, {1.0, 0.0}, 0.1);
  layout.end_markers.push_back({{1.5, 0.0}, 0.2});
  EXPECT_EQ(distance_to_paint_m(layout, {1.5, 0.1}), 0.0);
  EXPECT_NEAR(distance_to_paint_m(layout, {1.5, 0.5}), 0.3, 1e-12);
}

}  // namespace
}  // namespace lineservo::vehicle
