// Floors that are no grid: forks, hairpins, tight arcs, widths that change at a node; written into a
// temporary folder and flown as a user's own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/flight/mission.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

struct OddFloor {
  const char* name;
  const char* nodes;
  const char* edges;
  std::vector<const char*> targets;
};

class OddFloors : public ::testing::TestWithParam<OddFloor> {
 protected:
  FlownMission fly(const std::string& target, std::uint64_t seed) const {
    FlightRequest request;
    request.layout =
        temp_
            .write("odd.yaml", std::string("name: odd\nline: {width_m: 0.05}\nnodes:\n") + GetParam().nodes +
                                   "edges:\n" + GetParam().edges + "start: {node: s}\n")
            .string();
    request.instruction = "node:" + target;
    apply_conditions(request, "paper");
    apply_override(request, "speed_m_s=0.3");
    request.seed = seed;
    return fly_mission(prepare(request));
  }
  const testing::TempFolder temp_;
};

TEST_P(OddFloors, EveryTargetIsReached) {
  for (const char* target : GetParam().targets) {
    for (const std::uint64_t seed : {21u, 22u}) {
      SCOPED_TRACE(std::string(target) + ", seed " + std::to_string(seed));
      const FlownMission flown = fly(target, seed);
      EXPECT_EQ(flown.summary.outcome, "arrived");
      ASSERT_TRUE(flown.summary.rest);
      EXPECT_LT(flown.summary.rest->target_error_m, 0.03);
      EXPECT_LT(flown.summary.track.all.rmse_m, 0.03);
    }
  }
}

const OddFloor kOddFloors[] = {
    {"Y",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: y, x_m: 1.5, y_m: 0}\n"
     "  - {name: a, x_m: 2.5, y_m: 1}\n  - {name: b, x_m: 2.5, y_m: -1}\n",
     "  - {from: s, to: y}\n  - {from: y, to: a}\n  - {from: y, to: b}\n",
     {"y", "a", "b"}},
    {"BranchAt60",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: f, x_m: 1.5, y_m: 0}\n"
     "  - {name: a, x_m: 2.25, y_m: 1.3}\n  - {name: b, x_m: 3, y_m: 0}\n",
     "  - {from: s, to: f, width_m: 0.12}\n  - {from: f, to: a}\n  - {from: f, to: b, width_m: 0.08}\n",
     {"f", "a", "b"}},
    {"Hairpin",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: h, x_m: 2, y_m: 0}\n  - {name: a, x_m: 1, y_m: 1}\n",
     "  - {from: s, to: h}\n  - {from: h, to: a}\n",
     {"a"}},
    {"WidthThatChangesAtATee",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: t, x_m: 1.5, y_m: 0}\n"
     "  - {name: a, x_m: 3, y_m: 0}\n  - {name: b, x_m: 1.5, y_m: 1.2}\n",
     "  - {from: s, to: t, width_m: 0.2}\n  - {from: t, to: a}\n  - {from: t, to: b}\n",
     {"a", "b"}},
    {"BroaderBehindATee",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: t, x_m: 1.5, y_m: 0}\n"
     "  - {name: a, x_m: 3, y_m: 0}\n  - {name: b, x_m: 1.5, y_m: 1.2}\n",
     "  - {from: s, to: t}\n  - {from: t, to: a, width_m: 0.2}\n  - {from: t, to: b}\n",
     {"a", "b"}},
    {"WidthThatChangesAtABend",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: k, x_m: 1.5, y_m: 0}\n  - {name: a, x_m: 2.5, y_m: 0.8}\n",
     "  - {from: s, to: k, width_m: 0.2}\n  - {from: k, to: a, width_m: 0.08}\n",
     {"a"}},
    {"ArcOfOneMetre",
     "  - {name: s, x_m: 0, y_m: 0}\n  - {name: k, x_m: 1, y_m: 0}\n  - {name: a, x_m: 2, y_m: 1}\n",
     "  - {from: s, to: k}\n  - {from: k, to: a, arc: {centre: [1, 1], direction: left}}\n",
     {"a"}},
};

INSTANTIATE_TEST_SUITE_P(All, OddFloors, ::testing::ValuesIn(kOddFloors),
                         [](const auto& odd) { return std::string(odd.param.name); });

TEST(OddFloor, TheYardThatShipsIsFlown) {
  FlightRequest request;
  request.layout = "yard";
  request.instruction = "node:dock7";
  apply_conditions(request, "paper");
  apply_override(request, "speed_m_s=0.3");
  EXPECT_EQ(fly_mission(prepare(request)).summary.outcome, "arrived");
}

// A yellow aisle with white ways off it and a yellow one off those, of two widths.
TEST(TwoColours, AYellowAndWhiteFloorIsFlown) {
  const testing::TempFolder temp;
  FlightRequest request;
  request.layout =
      temp.write(
              "two.yaml",
              "name: two\nline: {width_m: 0.1}\nnodes:\n"
              "  - {name: s, x_m: 0, y_m: 0}\n  - {name: m, x_m: 2, y_m: 0}\n  - {name: r, x_m: 4, y_m: 0}\n"
              "  - {name: t, x_m: 2, y_m: 1.5}\n  - {name: u, x_m: 2, y_m: 3}\n  - {name: v, x_m: 0.5, y_m: "
              "1.5}\n"
              "edges:\n  - {from: s, to: m}\n  - {from: m, to: r}\n  - {from: t, to: v}\n"
              "  - {from: m, to: t, colour: [235, 235, 235], width_m: 0.06}\n"
              "  - {from: t, to: u, colour: [235, 235, 235], width_m: 0.06}\nstart: {node: s}\n")
          .string();
  apply_conditions(request, "paper");
  apply_override(request, "speed_m_s=0.3");
  apply_override(request, "features.segmenter=yellow-white");
  for (const std::string target : {"r", "u", "v"}) {
    for (const std::uint64_t seed : {21u, 22u}) {
      SCOPED_TRACE(target + ", seed " + std::to_string(seed));
      request.instruction = "node:" + target;
      request.seed = seed;
      const FlownMission flown = fly_mission(prepare(request));
      EXPECT_EQ(flown.summary.outcome, "arrived");
      ASSERT_TRUE(flown.summary.rest);
      EXPECT_LT(flown.summary.rest->target_error_m, 0.03);
      EXPECT_LT(flown.summary.track.all.rmse_m, 0.03);
    }
  }
}

}  // namespace
}  // namespace lineservo::apps
