#include "apps/scoring/route_truth.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"
#include "tests/apps/test_floors.h"

namespace lineservo::apps {
namespace {

using features::kPi;
using testing::plan_on;
using testing::shipped_layout;

constexpr double kRow_m = 6.8 / 3.0;

TEST(RouteTruth, A13HasALegAlongXAndOneAlongY) {
  const vehicle::Layout floor = shipped_layout("warehouse");
  const RouteTruth route = route_truth(floor, plan_on(floor, "a13"));
  ASSERT_EQ(route.legs.size(), 2u);
  EXPECT_EQ(route.legs[0].from + route.legs[0].to + route.legs[0].axis, "n00n10x");
  EXPECT_EQ(route.legs[1].from + route.legs[1].to + route.legs[1].axis, "n10n13y");
  EXPECT_NEAR(route.legs[0].start_heading_rad, 0.0, 1e-12);
  EXPECT_NEAR(route.legs[1].start_heading_rad, kPi / 2, 1e-12);
  EXPECT_EQ(route.legs[0].edges.size(), 1u);
  EXPECT_EQ(route.legs[1].edges.size(), 3u);
  EXPECT_EQ(route.closing_steps, (std::vector<int>{0, 3}));
  EXPECT_EQ(floor.nodes[route.target].name, "n13");
  ASSERT_EQ(route.nodes.size(), 4u);
  EXPECT_EQ(floor.nodes[route.nodes[1]].name, "n11");
}

TEST(RouteTruth, ABendIsOneLegOfNoAxisAndItsPlainNodesAreDrivenOver) {
  const vehicle::Layout floor = shipped_layout("bend");
  const RouteTruth route = route_truth(floor, plan_on(floor, "node:end"));
  ASSERT_EQ(route.legs.size(), 1u);
  EXPECT_EQ(route.legs[0].axis, "");
  EXPECT_EQ(route.legs[0].edges.size(), 3u);
  EXPECT_NEAR(route.legs[0].end_heading_rad, kPi / 4, 1e-9);
}

TEST(RouteTruth, AnEdgePaintedTheOtherWayRoundIsTravelledReversed) {
  vehicle::Layout floor;
  floor.nodes = {{"p", {0, 0}}, {"q", {4, 0}}};
  floor.edges = {testing::straight_edge(floor, 1, 0, 0.1)};
  const RouteTruth route = route_truth(floor, plan_on(floor, "node:q"));
  EXPECT_TRUE(route.legs[0].edges[0].reversed);
  EXPECT_NEAR(route.legs[0].start_heading_rad, 0.0, 1e-12);
  EXPECT_NEAR(offset_from(route.legs[0], {1.0, 0.25}).signed_m, 0.25, 1e-12);
  EXPECT_NEAR(offset_from(route.legs[0], {-1.0, 0.25}).signed_m, 0.25, 1e-12);
}

TEST(RouteTruth, ARoundIsOneLegAndItsFarSideIsNotBehindTheStart) {
  const vehicle::Layout floor = shipped_layout("circle");
  const RouteTruth route = route_truth(floor, plan_on(floor, "d00"));
  ASSERT_EQ(route.legs.size(), 1u);
  EXPECT_EQ(route.legs[0].edges.size(), 4u);
  EXPECT_EQ(route.target, floor.start);
  EXPECT_NEAR(offset_from(route.legs[0], {-5.4, 0.0}).distance_m, 0.1, 1e-9);
  EXPECT_NEAR(offset_from(route.legs[0], {-5.2, 0.0}).signed_m, 0.1, 1e-9);  // to the inside, which is left
}

class OffsetTest : public ::testing::Test {
 protected:
  const vehicle::Layout floor_ = shipped_layout("warehouse");
  const RouteTruth route_ = route_truth(floor_, plan_on(floor_, "a13"));
  const LegTruth& along_x_ = route_.legs[0];  // from (0.6, 0.6) to (4.2, 0.6)
  const LegTruth& along_y_ = route_.legs[1];  // from (4.2, 0.6) to (4.2, 7.4)
};

TEST_F(OffsetTest, IsPositiveToTheLeftOfTravel) {
  EXPECT_NEAR(offset_from(along_x_, {2.0, 0.7}).signed_m, 0.1, 1e-12);
  EXPECT_NEAR(offset_from(along_x_, {2.0, 0.4}).signed_m, -0.2, 1e-12);
  EXPECT_NEAR(offset_from(along_x_, {2.0, 0.4}).distance_m, 0.2, 1e-12);
  EXPECT_NEAR(offset_from(along_y_, {4.1, 3.0}).signed_m, 0.1, 1e-12);
  EXPECT_NEAR(offset_from(along_y_, {4.5, 3.0}).signed_m, -0.3, 1e-12);
}

TEST_F(OffsetTest, GoesOnStraightBehindTheBeginning) {
  EXPECT_NEAR(offset_from(along_x_, {0.1, 0.65}).distance_m, 0.05, 1e-12);
  EXPECT_NEAR(offset_from(along_x_, {0.1, 0.65}).signed_m, 0.05, 1e-12);
}

TEST_F(OffsetTest, EndsAtTheEnd) {
  EXPECT_NEAR(offset_from(along_x_, {4.2 + 0.3, 0.6 + 0.4}).distance_m, 0.5, 1e-12);
  EXPECT_NEAR(offset_from(along_y_, {4.2, 7.4 + 0.25}).distance_m, 0.25, 1e-8);
}

TEST_F(OffsetTest, AfterANodeTheBeginningIsAnEndToo) {
  EXPECT_NEAR(offset_after_node(along_y_, {4.2, 0.5}).distance_m, 0.1, 1e-12);
  EXPECT_NEAR(offset_from(along_y_, {4.2, 0.5}).distance_m, 0.0, 1e-12);
}

TEST_F(OffsetTest, TakesTheNearestOfTheLegsEdges) {
  for (const double rows : {0.5, 1.0, 1.5, 2.5})
    EXPECT_NEAR(offset_from(along_y_, {4.3, 0.6 + rows * kRow_m}).distance_m, 0.1, 1e-12) << rows;
}

}  // namespace
}  // namespace lineservo::apps
