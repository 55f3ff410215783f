#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "apps/config/data_folder.h"
#include "apps/config/layout_file.h"
#include "apps/config/layout_topology.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::kPi;
using features::radians;

vehicle::Layout shipped(const std::string& name) {
  return read_layout(find_data(DataKind::layout, name));
}

TEST(ShippedLayouts, AllLoadAreSoundAndBearTheNameOfTheirFile) {
  for (const DataEntry& entry : list_data(DataKind::layout)) {
    const vehicle::Layout layout = shipped(entry.name);
    EXPECT_TRUE(vehicle::faults(layout).empty()) << entry.name;
    EXPECT_EQ(layout.name, entry.name);
    EXPECT_EQ(layout.description, entry.description);
  }
}

/// data/README.md: columns x = 0.6 + 3.6 i, rows y = 0.6 + (6.8 / 3) j.
Eigen::Vector2d grid_place(int i, int j) {
  return {0.6 + 3.6 * i, 0.6 + 6.8 / 3.0 * j};
}

class ShippedGrid : public ::testing::TestWithParam<std::pair<std::string, double>> {
 protected:
  const vehicle::Layout layout_ = shipped(GetParam().first);
};

TEST_P(ShippedGrid, HasANodeAtEveryCrossingOfSixColumnsAndFiveRows) {
  EXPECT_EQ(layout_.nodes.size(), 30u);
  for (int i = 0; i <= 5; ++i) {
    for (int j = 0; j <= 4; ++j) {
      const std::string dif = "a" + std::to_string(i) + std::to_string(j);
      ASSERT_TRUE(layout_.labels.contains(dif));
      EXPECT_LT((layout_.nodes[layout_.labels.at(dif)].p_W - grid_place(i, j)).norm(), 1e-8) << dif;
    }
  }
  EXPECT_EQ(layout_.labels.size(), 30u);
}

TEST_P(ShippedGrid, JoinsEveryNodeToItsNeighboursByOneStraightLine) {
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const vehicle::LayoutEdge& edge : layout_.edges) {
    const Eigen::Vector2d step = layout_.nodes[edge.to].p_W - layout_.nodes[edge.from].p_W;
    EXPECT_TRUE(pairs.insert(std::minmax(edge.from, edge.to)).second);
    EXPECT_NEAR(std::min(std::abs(step.x()), std::abs(step.y())), 0.0, 1e-12);
    EXPECT_NEAR(step.norm(), std::abs(step.x()) > 1.0 ? 3.6 : 6.8 / 3.0, 1e-8);
    EXPECT_NEAR(edge.centreline.length_m(), step.norm(), 1e-12);
    EXPECT_EQ(edge.width_m, GetParam().second);
  }
  EXPECT_EQ(pairs.size(), 5u * 5u + 6u * 4u);
}

TEST_P(ShippedGrid, StartsOnARedDiscInTheCorner) {
  EXPECT_LT((layout_.nodes[layout_.start].p_W - grid_place(0, 0)).norm(), 1e-12);
  ASSERT_EQ(layout_.start_markers.size(), 1u);
  EXPECT_EQ(layout_.start_markers[0].radius_m, 0.18);
  EXPECT_EQ(layout_.start_markers[0].p_W, layout_.nodes[layout_.start].p_W);
  const vehicle::Bgr colour = layout_.start_markers[0].colour;
  EXPECT_GT(colour[2], 2 * std::max(colour[0], colour[1]));
}

TEST_P(ShippedGrid, IsYellowOnGrey) {
  EXPECT_EQ(layout_.floor_colour[0], layout_.floor_colour[1]);
  EXPECT_EQ(layout_.floor_colour[1], layout_.floor_colour[2]);
  for (const vehicle::LayoutEdge& edge : layout_.edges) {
    EXPECT_GT(edge.colour[1], 180);
    EXPECT_GT(edge.colour[2], 180);
    EXPECT_LT(edge.colour[0], 60);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, ShippedGrid,
                         ::testing::Values(std::pair{"warehouse", 0.36}, std::pair{"tape-warehouse", 0.05}),
                         [](const auto& param) { return param.index == 0 ? "warehouse" : "tape_warehouse"; });

TEST(ShippedLayouts, StraightIsOneLineOfTenMetres) {
  const vehicle::Layout layout = shipped("straight");
  ASSERT_EQ(layout.edges.size(), 1u);
  EXPECT_DOUBLE_EQ(layout.edges[0].centreline.length_m(), 10.0);
  EXPECT_EQ(layout.edges[0].from, layout.start);
}

TEST(ShippedLayouts, BendTurnsByFortyFiveDegreesBetweenTwoMetres) {
  const vehicle::Layout layout = shipped("bend");
  ASSERT_EQ(layout.edges.size(), 3u);
  EXPECT_NEAR(layout.edges[0].centreline.length_m(), 1.0, 1e-12);
  EXPECT_NEAR(layout.edges[1].centreline.length_m(), 1.5 * kPi / 4.0, 1e-9);
  EXPECT_NEAR(layout.edges[2].centreline.length_m(), 1.0, 1e-9);
  EXPECT_NEAR(layout.edges[1].centreline.at(0.5).curvature_inv_m, 1.0 / 1.5, 1e-9);
}

TEST(ShippedLayouts, BendHasNoKinks) {
  const vehicle::Layout layout = shipped("bend");
  for (std::size_t i = 0; i + 1 < layout.edges.size(); ++i) {
    const vehicle::Curve &curve = layout.edges[i].centreline, &next = layout.edges[i + 1].centreline;
    EXPECT_NEAR(curve.at(curve.length_m()).heading_rad, next.at(0.0).heading_rad, 1e-9);
  }
  EXPECT_NEAR(layout.edges[2].centreline.at(1.0).heading_rad, radians(45.0), 1e-9);
}

/// A mid-side of a regular polygon of this apothem, counter-clockwise from the bottom.
Eigen::Vector2d mid_side(int k, int sides, double apothem_m) {
  const double angle_rad = -kPi / 2 + 2.0 * kPi * k / sides;
  return apothem_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
}

void expect_ring_of_tees(const vehicle::Layout& layout, char zone, int sides) {
  const servo::Topology topology = topology_of(layout);
  for (int k = 0; k < sides; ++k) {
    const std::string name{zone, '0', static_cast<char>('0' + k)};
    const std::size_t node = k == 0 ? layout.start : layout.labels.at(name);
    EXPECT_LT((layout.nodes[node].p_W - mid_side(k, sides, 4.8)).norm(), 1e-8) << name;
    EXPECT_EQ(topology.nodes[node].arms.size(), 3u) << name;
  }
  double around_m = 0.0;
  for (const vehicle::LayoutEdge& edge : layout.edges) around_m += edge.centreline.length_m();
  EXPECT_NEAR(around_m, sides * (2.0 * 4.8 * std::tan(kPi / sides) + 0.6), 1e-6);
}

TEST(ShippedLayouts, ZonesBAndCAreRingsWithTeesToTheInside) {
  expect_ring_of_tees(shipped("square"), 'b', 4);
  expect_ring_of_tees(shipped("octagon"), 'c', 8);
}

TEST(ShippedLayouts, ZoneDIsACircle) {
  const vehicle::Layout layout = shipped("circle");
  double around_m = 0.0;
  for (const vehicle::LayoutEdge& edge : layout.edges) {
    around_m += edge.centreline.length_m();
    EXPECT_NEAR(edge.centreline.at(1.0).p_W.norm(), 5.3, 1e-9);
  }
  EXPECT_NEAR(around_m, 2.0 * kPi * 5.3, 1e-9);
}

}  // namespace
}  // namespace lineservo::apps
