#include "vehicle/floor/overlaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using features::radians;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Nodes n0, n1, … at the places.
Layout with_nodes(const std::vector<Vector2d>& places_W) {
  Layout layout;
  for (const Vector2d& p_W : places_W) test::add_node(layout, "n" + std::to_string(layout.nodes.size()), p_W);
  return layout;
}

void add(Layout& layout, std::size_t from, std::size_t to, Curve curve, double width_m = 0.1) {
  layout.edges.push_back({from, to, std::move(curve), width_m});
}

/// Two straight lines, n0 to n1 and n2 to n3.
Layout two_lines(const std::vector<Vector2d>& ends_W, double width_m = 0.1) {
  Layout layout = with_nodes(ends_W);
  test::add_line(layout, 0, 1, width_m);
  test::add_line(layout, 2, 3, width_m);
  return layout;
}

TEST(Overlaps, LinesThatCrossWithoutANodeAreTold) {
  for (const double width_m : {0.005, 0.05, 0.36}) {
    EXPECT_THAT(
        overlaps(two_lines({{0, 0}, {4, 0}, {2.3, -2}, {1.7, 2}}, width_m)),
        ElementsAre(AllOf(HasSubstr("edge 0 (n0 to n1) and edge 1 (n2 to n3)"), HasSubstr("nodes only"))))
        << width_m;
  }
}

TEST(Overlaps, ALineAcrossAnArcIsTold) {
  Layout layout = with_nodes({{2, 0}, {-2, 0}, {0, 0.5}, {0, 4}});
  add(layout, 0, 1, Curve::arc({2, 0}, {-2, 0}, {0, 0}, true));
  test::add_line(layout, 2, 3, 0.1);
  EXPECT_THAT(overlaps(layout), ElementsAre(HasSubstr("(0.")));
  layout.edges[0].centreline = Curve::arc({2, 0}, {-2, 0}, {0, 0}, false);  // the half below
  EXPECT_THAT(overlaps(layout), IsEmpty());
}

TEST(Overlaps, ALineThatEndsOnAnotherWithoutANodeIsTold) {
  EXPECT_THAT(overlaps(two_lines({{0, 0}, {4, 0}, {2, 0}, {2, 3}})), ElementsAre(HasSubstr("edge 1")));
}

TEST(Overlaps, LinesSideBySideMayNotTouch) {
  EXPECT_THAT(overlaps(two_lines({{0, 0}, {4, 0}, {0, 0.09}, {4, 0.09}})).size(), 1u);
  EXPECT_THAT(overlaps(two_lines({{0, 0}, {4, 0}, {0, 0.11}, {4, 0.11}})), IsEmpty());
}

TEST(Overlaps, TheSameLineTwiceIsToldHoweverShort) {
  for (const double length_m : {0.1, 1.0, 5.0}) {
    Layout layout = with_nodes({{0, 0}, {length_m, 0}});
    test::add_line(layout, 0, 1, 0.36);
    test::add_line(layout, 1, 0, 0.36);
    EXPECT_THAT(overlaps(layout), ElementsAre(HasSubstr("edge 1 (n1 to n0) doubles edge 0 (n0 to n1)")));
  }
}

TEST(Overlaps, TwoWaysBetweenTheSameNodesAreSound) {
  Layout layout = with_nodes({{2, 0}, {-2, 0}});
  add(layout, 0, 1, Curve::arc({2, 0}, {-2, 0}, {0, 0}, true), 0.36);
  add(layout, 1, 0, Curve::arc({-2, 0}, {2, 0}, {0, 0}, true), 0.36);
  EXPECT_THAT(overlaps(layout), IsEmpty());
}

TEST(Overlaps, ArmsPartAtTwentyFiveDegreesOrMore) {
  for (const double width_m : {0.05, 0.36}) {
    for (double angle_deg = 25.0; angle_deg <= 180.0; angle_deg += 5.0)
      EXPECT_THAT(overlaps(test::star({0.3, 0.3 + radians(angle_deg)}, width_m)), IsEmpty()) << angle_deg;
    for (const double angle_deg : {0.0, 1.0, 5.0, 10.0, 20.0})
      EXPECT_EQ(overlaps(test::star({0.3, 0.3 + radians(angle_deg)}, width_m)).size(), 1u) << angle_deg;
  }
}

TEST(Overlaps, AnArcThatLeavesALineInItsDirectionIsTold) {
  Layout layout = with_nodes({{0, 0}, {5, 0}, {3, 3}});
  test::add_line(layout, 0, 1, 0.1);
  add(layout, 0, 2, Curve::arc({0, 0}, {3, 3}, {0, 3}, true));
  EXPECT_EQ(overlaps(layout).size(), 1u);
}

TEST(Overlaps, ALineThatCrossesItselfIsTold) {
  Layout layout = with_nodes({{0, 0}, {0, 4}});
  add(layout, 0, 1, Curve::polyline({{0, 0}, {4, 2}, {4, 0}, {0, 4}}));
  EXPECT_THAT(overlaps(layout),
              ElementsAre(AllOf(HasSubstr("edge 0 (n0 to n1) runs over itself"), HasSubstr("node"))));
}

TEST(Overlaps, ALineThatRunsBackOverItselfIsTold) {
  Layout layout = with_nodes({{0, 0}, {0, 0.3}});
  add(layout, 0, 1, Curve::polyline({{0, 0}, {4, 0}, {0, 0.3}}));
  EXPECT_THAT(overlaps(layout), ElementsAre(HasSubstr("itself")));
}

// Pieces much shorter than the line is wide, in one edge or with a node at each joint.
TEST(Overlaps, FinePiecesOfABendAreSound) {
  std::vector<Vector2d> places_W;
  for (int k = 0; k <= 40; ++k) {
    const double angle_rad = radians(3.0 * k);
    places_W.emplace_back(1.0 * std::sin(angle_rad), 1.0 - std::cos(angle_rad));
  }
  Layout one = with_nodes({places_W.front(), places_W.back()}), many = with_nodes(places_W);
  add(one, 0, 1, Curve::polyline(places_W), 0.36);
  for (std::size_t k = 1; k < places_W.size(); ++k) test::add_line(many, k - 1, k, 0.36);
  EXPECT_THAT(overlaps(one), IsEmpty());
  EXPECT_THAT(overlaps(many), IsEmpty());
}

TEST(Overlaps, SoundLayoutsHaveNone) {
  EXPECT_THAT(overlaps(test::warehouse(0.36)), IsEmpty());
  EXPECT_THAT(overlaps(test::warehouse(0.05)), IsEmpty());
  EXPECT_THAT(overlaps(test::circle()), IsEmpty());
  EXPECT_THAT(overlaps(test::bend()), IsEmpty());
}

TEST(Overlaps, FaultsOfALayoutNameThem) {
  EXPECT_THAT(faults(two_lines({{0, 0}, {4, 0}, {2, -2}, {2, 2}})),
              ElementsAre(HasSubstr("run over each other")));
}

}  // namespace
}  // namespace lineservo::vehicle
