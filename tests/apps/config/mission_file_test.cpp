#include "apps/config/mission_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/flight_request.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using testing::TempFolder;

class MissionFileTest : public ::testing::Test {
 protected:
  MissionFile read(const std::string& text) const { return read_mission(temp_.write("tour.yaml", text)); }
  /// What is wrong with one target.
  std::string fault(const std::string& target) const {
    return complaint([&] { read("name: tour\ntargets:\n  - a13\n  - " + target + "\n"); });
  }
  const TempFolder temp_;
};

TEST_F(MissionFileTest, ReadsTargetsActionsAndTheChargingStation) {
  const MissionFile mission = read(
      "name: tour\n"
      "description: all of it\n"
      "layout: warehouse\n"
      "targets:\n"
      "  - a13\n"
      "  - {target: node:n42, hover_s: 4.5, look: true}\n"
      "  - {target: a20, land: true, ground_s: 10}\n"
      "  - return\n"
      "charging_station: a01\n");
  EXPECT_EQ(mission.name, "tour");
  EXPECT_EQ(mission.layout, "warehouse");
  ASSERT_EQ(mission.targets.size(), 5u);
  EXPECT_EQ(mission.targets[0].target, "a13");
  EXPECT_FALSE(mission.targets[0].stop.hover_s);
  EXPECT_EQ(mission.targets[1].target, "node:n42");
  EXPECT_EQ(mission.targets[1].stop.hover_s, 4.5);
  EXPECT_TRUE(mission.targets[1].stop.look);
  EXPECT_EQ(mission.targets[1].line, 6);
  EXPECT_TRUE(mission.targets[2].stop.land);
  EXPECT_EQ(mission.targets[2].stop.ground_s, 10.0);
  EXPECT_EQ(mission.targets[3].target, kReturn);
  EXPECT_EQ(mission.targets[4].target, "a01");
  EXPECT_TRUE(mission.targets[4].stop.land);
}

TEST_F(MissionFileTest, NamesTheLineAndTheKeyOfAFault) {
  EXPECT_THAT(fault("{target: a23, hover_s: 1}"),
              AllOf(HasSubstr("tour.yaml:4: "), HasSubstr("'hover_s' must be 3")));
  EXPECT_THAT(fault("{target: a23, hover_s: x}"), AllOf(HasSubstr("tour.yaml:4: "), HasSubstr("hover_s")));
  EXPECT_THAT(fault("{target: a23, wait: 1}"), AllOf(HasSubstr("tour.yaml:4: "), HasSubstr("wait")));
  EXPECT_THAT(fault("{target: a23, look: maybe}"), HasSubstr("'look' must be true or false"));
  EXPECT_THAT(fault("{target: a23, ground_s: 5}"), HasSubstr("goes with 'land: true'"));
  EXPECT_THAT(fault("{target: a23, land: true, ground_s: -1}"), HasSubstr("'ground_s' must be 0"));
  EXPECT_THAT(fault("{look: true}"), HasSubstr("target"));
  EXPECT_THAT(fault("[a23]"), HasSubstr("tour.yaml:4: a target is"));
  EXPECT_THAT(complaint([&] { read("name: tour\n"); }), HasSubstr("'targets' must be a list"));
  EXPECT_THAT(complaint([&] { read("name: tour\ntargets: []\n"); }), HasSubstr("tour.yaml:2: 'targets'"));
  EXPECT_THAT(complaint([&] { read("name: tour\ntargets: [a13]\ncharging_station: [a]\n"); }),
              HasSubstr("'charging_station' must be"));
  EXPECT_THAT(complaint([&] { read("name: tour\ntargets: [a13]\nsteps: 3\n"); }), HasSubstr("steps"));
}

TEST_F(MissionFileTest, TheFloorIsThatOfTheMissionOrOfItsFirstTarget) {
  const auto floor = [this](const std::string& text) {
    return layout_of_zone(temp_.write("tour.yaml", "name: tour\n" + text).string());
  };
  EXPECT_EQ(floor("targets: [b01, b02]\n"), "square");
  EXPECT_EQ(floor("layout: tape-warehouse\ntargets: [a13]\n"), "tape-warehouse");
  EXPECT_EQ(floor("layout: hall.yaml\ntargets: [a13]\n"), (temp_.path() / "hall.yaml").string());
  EXPECT_EQ(layout_of_zone("stock-take.yaml"), "warehouse") << "ships";
  EXPECT_THAT(complaint([] { layout_of_zone("none.yaml"); }),
              AllOf(HasSubstr("no mission 'none.yaml'"), HasSubstr("stock-take.yaml")));
}

}  // namespace
}  // namespace lineservo::apps
