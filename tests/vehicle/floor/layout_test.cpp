#include "vehicle/floor/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::vehicle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Layout line() {
  return test::single_line({0.0, 0.0}, {1.0, 0.0}, 0.1);
}

TEST(LayoutFaults, SoundLayoutsHaveNone) {
  EXPECT_THAT(faults(test::warehouse()), IsEmpty());
  EXPECT_THAT(faults(test::circle()), IsEmpty());
  EXPECT_THAT(faults(test::bend()), IsEmpty());
  EXPECT_EQ(test::warehouse().edges.size(), 49U);
}

TEST(LayoutFaults, NamesAnEmptyLayoutsFaults) {
  EXPECT_THAT(faults(Layout{}), ElementsAre(HasSubstr("at least one edge"), HasSubstr("start")));
}

TEST(LayoutFaults, NamesIndicesOutOfRange) {
  Layout layout = line();
  layout.edges[0].to = 2;
  layout.labels["a01"] = 7;
  layout.start = 2;
  EXPECT_THAT(faults(layout),
              ElementsAre("start: no such node", "label a01: no such node", "edge 0: no such node"));
}

TEST(LayoutFaults, NamesANameThatIsUsedTwice) {
  Layout layout = line();
  layout.nodes[1].name = "from";
  EXPECT_THAT(faults(layout), ElementsAre("node from: the name is used twice"));
}

TEST(LayoutFaults, BoundsTheWidthOnBothSides) {
  for (const double good_m : {0.005, 2.0}) {
    Layout layout = line();
    layout.edges[0].width_m = good_m;
    EXPECT_THAT(faults(layout), IsEmpty()) << good_m;
  }
  for (const double bad_m : {0.00499, 2.001, std::numeric_limits<double>::quiet_NaN()}) {
    Layout layout = line();
    layout.edges[0].width_m = bad_m;
    EXPECT_THAT(faults(layout), ElementsAre(HasSubstr("width"))) << bad_m;
  }
}

TEST(LayoutFaults, CentrelinesStartAndEndOnTheirNodesToAMillimetre) {
  Layout layout = line();
  layout.edges[0].centreline = Curve::line({0.0009, 0.0}, {1.0, 0.0009});
  EXPECT_THAT(faults(layout), IsEmpty());
  layout.edges[0].centreline = Curve::line({0.0011, 0.0}, {1.0, 0.0011});
  EXPECT_THAT(faults(layout),
              ElementsAre(HasSubstr("does not start on node from"), HasSubstr("does not end on node to")));
}

TEST(LayoutFaults, NamesWhatIsNotFinite) {
  Layout layout = line();
  layout.nodes[0].p_W.x() = std::numeric_limits<double>::infinity();
  layout.edges[0].centreline = Curve{};
  EXPECT_THAT(faults(layout), ElementsAre(HasSubstr("node from"), HasSubstr("centreline is empty")));
}

// Beyond, single precision draws wrongly, and far beyond it overflows.
TEST(LayoutFaults, NamesWhatIsTooFarAwayToBeDrawn) {
  EXPECT_THAT(faults(test::single_line({9999.0, -9999.0}, {10000.0, -10000.0}, 0.1)), IsEmpty());
  EXPECT_THAT(faults(test::single_line({0.0, 0.0}, {0.0, 20000.0}, 0.1)), ElementsAre(HasSubstr("node to")));
  Layout layout = line();
  layout.edges[0].centreline = Curve::polyline({{0.0, 0.0}, {0.5, 10001.0}, {1.0, 0.0}});
  EXPECT_THAT(faults(layout), ElementsAre(HasSubstr("within 10000 m")));
  layout.edges[0].centreline = Curve::arc({0.0, 0.0}, {1.0, 0.0}, {0.5, 1001.0}, true);
  EXPECT_THAT(faults(layout), ElementsAre(HasSubstr("radius of up to 1000 m")));
}

TEST(LayoutFaults, NamesMarkersOutOfBounds) {
  Layout layout = line();
  layout.start_markers.push_back({{0.0, 0.0}, 0.0});
  layout.end_markers.push_back({{0.0, 0.0}, 2.5});
  EXPECT_THAT(faults(layout), ElementsAre(HasSubstr("start marker 0"), HasSubstr("end marker 0")));
}

}  // namespace
}  // namespace lineservo::vehicle
