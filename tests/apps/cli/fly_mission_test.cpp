#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::read_text;

/// Missions over a line of 1.2 m between the dead ends p and q, and from there by 1 m to r.
class FlyMissionTest : public ProgramTest {
 protected:
  FlyMissionTest() {
    temp_.write(
        "line.yaml",
        "name: line\n"
        "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 1.2, y_m: 0}, {name: r, x_m: 1.2, y_m: 1}]\n"
        "edges: [{from: p, to: q, width_m: 0.1}, {from: q, to: r, width_m: 0.05}]\n"
        "start: {node: p}\n");
  }
  std::string mission(const std::string& targets) const {
    return temp_.write("tour.yaml", "name: tour\nlayout: line.yaml\ntargets:\n" + targets).string();
  }
};

TEST_F(FlyMissionTest, VisitsItsTargetsAndReportsEach) {
  const std::string tour = mission(
      "  - {target: node:q, hover_s: 3, look: true}\n"
      "  - {target: node:r, hover_s: 3, land: true, ground_s: 1}\n"
      "  - return\n");
  const Ran ran = run({"fly", tour, "--conditions", "ideal", "--json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  const nlohmann::json json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["outcome"], "arrived");
  EXPECT_EQ(json["target"]["node"], "p");
  ASSERT_EQ(json["targets"].size(), 3u);
  EXPECT_EQ(json["targets"][0]["outcome"], "arrived");
  EXPECT_EQ(json["targets"][1]["outcome"], "landed");
  EXPECT_EQ(json["targets"][2]["target"], "return");
  for (const nlohmann::json& target : json["targets"]) EXPECT_LT(target["terminal_error_m"], 0.03);
  EXPECT_LT(json["targets"][1]["landing_error_m"], 0.1);
  EXPECT_EQ(json["legs"].size(), 4u) << "p to q, q to r, r to q, q to p";
  EXPECT_EQ(json["legs"][2]["from"], "r");
  EXPECT_LT(json["tracking"]["rmse_m"], 0.03);
}

// What the mission itself waits is no reason to break it off.
TEST_F(FlyMissionTest, ItsWaitsDoNotCountForTheTimeLimit) {
  const std::string tour =
      mission("  - {target: node:q, hover_s: 60, land: true, ground_s: 40}\n  - return\n");
  const Ran ran = run({"fly", tour, "--conditions", "paper", "--set", "time_limit_s=60", "--json"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_GT(nlohmann::json::parse(ran.out)["duration_s"], 120.0);
}

TEST_F(FlyMissionTest, ExplainsTheWayWithWhatIsDoneAtTheTargets) {
  const std::string tour =
      mission("  - {target: node:r, hover_s: 3, look: true}\ncharging_station: return\n");
  const Ran ran = run({"fly", tour, "--explain"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("to r, p, starting towards 0°"), HasSubstr("turn 90° left"),
                             HasSubstr("hover 3 s, look round, turn round"), HasSubstr("turn 90° right"),
                             HasSubstr("hover 3 s, land")));
}

TEST_F(FlyMissionTest, NamesTheLineOfATargetThatCannotBeFlown) {
  EXPECT_THAT(refusal({"fly", mission("  - node:q\n  - node:s\n")}),
              AllOf(HasSubstr("tour.yaml:5: "), HasSubstr("no node 's'"), HasSubstr("p, q, r")));
  EXPECT_THAT(refusal({"fly", mission("  - node:q\n  - node:q\n")}),
              AllOf(HasSubstr("tour.yaml:5: "), HasSubstr("where the target before is")));
  EXPECT_THAT(refusal({"fly", mission("  - a13\n")}), AllOf(HasSubstr("tour.yaml:4: "), HasSubstr("a13")));
  EXPECT_THAT(refusal({"fly", "none.yaml"}), AllOf(HasSubstr("no mission"), HasSubstr("stock-take.yaml")));
}

TEST_F(FlyMissionTest, ItsFolderRepeatsItWhereverItIs) {
  const std::string tour = mission("  - {target: node:q, hover_s: 3}\n");
  const std::string out = path("out").string();
  ASSERT_EQ(run({"fly", tour, "--conditions", "ideal", "--out", out}).exit_code, 0);
  EXPECT_EQ(read_text(path("out/mission.yaml")), read_text(tour));
  fs::remove(tour);
  fs::remove(path("line.yaml"));
  fs::rename(out, path("moved"));
  const Ran again = run({"fly", "--config", path("moved/config.yaml").string(), "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto hash = [](const std::string& text) {
    return nlohmann::json::parse(text)["trajectory_sha256"].get<std::string>();
  };
  EXPECT_EQ(hash(again.out), hash(read_text(path("moved/summary.json"))));
}

TEST_F(FlyMissionTest, TheMissionThatShipsIsCompiled) {
  EXPECT_THAT(run({"fly", "stock-take.yaml", "--explain"}).out, HasSubstr("hover 3 s, land"));
  EXPECT_THAT(run({"missions"}).out, HasSubstr("stock-take.yaml"));
}

TEST_F(FlyMissionTest, AMissionThatNamesItselfFirstIsRefused) {
  const std::string tour = temp_.write("m.yaml", "name: m\ntargets: [m.yaml]\n").string();
  const Ran ran = run({"fly", tour, "--explain"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("'m.yaml' is not an instruction"));
}

TEST_F(FlyMissionTest, AFileOfTheUsersOwnInTheFolderIsNotReplaced) {
  fs::create_directories(path("own"));
  const std::string text = "name: my floor, unfinished\n";
  temp_.write("own/layout.yaml", text);
  const Ran ran = run({"fly", "a13", "--out", path("own")});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("holds a layout.yaml that is of no earlier flight"));
  EXPECT_EQ(read_text(path("own/layout.yaml")), text);
}

// Nor taken for the earlier flight's, to be removed by the next.
TEST_F(FlyMissionTest, NothingByTheNameOfAResultIsReplacedWhereNoFlightWas) {
  for (const char* name : {"recording.csv", "report.html", "flight.mp4", "flight.csv"}) {
    const std::string folder = std::string("with-") + name;
    fs::create_directories(path(folder));
    temp_.write(folder + "/" + name, "mine");
    EXPECT_THAT(refusal({"fly", "a13", "--out", path(folder)}), HasSubstr(name));
    EXPECT_EQ(read_text(path(folder) / name), "mine");
  }
}

}  // namespace
}  // namespace lineservo::apps
