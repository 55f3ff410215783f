#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/report/report_page.h"
#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using testing::read_text;
using ::testing::StartsWith;
using FlyCommandTest = ProgramTest;

TEST_F(FlyCommandTest, RefusesAFlightWithoutTarget) {
  EXPECT_THAT(refusal({"fly"}), HasSubstr("TARGET is missing"));
}

TEST_F(FlyCommandTest, RefusesTargetsThatAreNone) {
  EXPECT_THAT(refusal({"fly", "e13"}),
              AllOf(HasSubstr("'e13' is not an instruction"), HasSubstr("a13"), HasSubstr("d00")));
  EXPECT_THAT(refusal({"fly", "A13"}), HasSubstr("is not an instruction"));
  EXPECT_THAT(refusal({"fly", "a1"}), HasSubstr("is not an instruction"));
  EXPECT_THAT(refusal({"fly", "b04"}), HasSubstr("b00 to b03"));
  EXPECT_THAT(refusal({"fly", "a99"}), AllOf(HasSubstr("no target a99"), HasSubstr("a54")));
  EXPECT_THAT(refusal({"fly", "a00"}), HasSubstr("take-off point"));
  EXPECT_THAT(refusal({"fly", "node:x"}), HasSubstr("no node 'x'"));
  EXPECT_THAT(refusal({"fly", "a13", "--layout", "straight"}), HasSubstr("no target a13"));
}

TEST_F(FlyCommandTest, RefusesNamesThatDoNotShip) {
  EXPECT_THAT(refusal({"fly", "a13", "--controller", "lqr"}),
              AllOf(HasSubstr("lqr"), HasSubstr("ibvs"), HasSubstr("pid")));
  EXPECT_THAT(refusal({"fly", "a13", "--layout", "hall"}),
              AllOf(HasSubstr("no layout 'hall'"), HasSubstr("warehouse")));
  EXPECT_THAT(refusal({"fly", "a13", "--conditions", "storm"}),
              AllOf(HasSubstr("no conditions 'storm'"), HasSubstr("paper")));
}

TEST_F(FlyCommandTest, RefusesFilesThatCannotBeReadOrAreWrong) {
  EXPECT_THAT(refusal({"fly", "--config", path("none.yaml")}), HasSubstr("none.yaml: cannot be read"));
  const std::string broken = temp_.write("broken.yaml", "name: x\nnodes: [1, 2\n");
  EXPECT_THAT(refusal({"fly", "a13", "--layout", broken}), HasSubstr("broken.yaml:"));
  const std::string unknown = temp_.write("unknown.yaml", "speed_m_s: 0.1\ncamera: {zoom: 3}\n");
  EXPECT_THAT(refusal({"fly", "a13", "--conditions", unknown}),
              HasSubstr("unknown.yaml:2: unknown key 'camera.zoom'"));
  EXPECT_THAT(refusal({"fly", "a13", "--config", unknown}),
              HasSubstr("unknown.yaml:2: unknown key 'camera.zoom'"));
  EXPECT_THAT(refusal({"fly", "a13", "--config", temp_.path()}), HasSubstr("is a folder"));
}

TEST_F(FlyCommandTest, RefusesSettingsThatAreNone) {
  EXPECT_THAT(refusal({"fly", "a13", "--set", "camera.zoom=3"}),
              AllOf(HasSubstr("--set"), HasSubstr("'camera.zoom'")));
  EXPECT_THAT(refusal({"fly", "a13", "--set", "speed_m_s"}), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(refusal({"fly", "a13", "--set", "speed_m_s=fast"}), HasSubstr("a number from 0.01 to 2"));
}

TEST_F(FlyCommandTest, RefusesASpeedThatIsSetTwice) {
  EXPECT_THAT(refusal({"fly", "a13", "--speed", "0.2", "--set", "speed_m_s=0.3"}),
              AllOf(HasSubstr("--speed"), HasSubstr("--set speed_m_s")));
}

TEST_F(FlyCommandTest, RefusesAVehicleThatCannotBe) {
  EXPECT_THAT(refusal({"fly", "a13", "--set", "vehicle.rotor_radius_m=0.5"}), HasSubstr("must not overlap"));
}

TEST_F(FlyCommandTest, RefusesToWriteWhereItCannotBeforeItFlies) {
  const std::string file = temp_.write("file", "x");
  EXPECT_THAT(refusal({"fly", "a13", "--out", file}), HasSubstr("--out"));
  EXPECT_THAT(refusal({"fly", "a13", "--out", "/proc/lineservo"}), HasSubstr("--out /proc/lineservo"));
  EXPECT_THAT(refusal({"fly", "a13", "--out", std::string(300, 'x')}), HasSubstr("File name too long"));
}

TEST_F(FlyCommandTest, AFullDiskIsOneErrorAndLeavesNothing) {
  const Ran ran = run(short_flight({"--out", path("out")}), 4096);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("flight.csv: cannot be written: "));
  EXPECT_TRUE(!fs::exists(path("out")) || fs::is_empty(path("out")));
}

TEST_F(FlyCommandTest, RefusesAResultNameThatIsNoFileBeforeItFlies) {
  for (const char* name : {"summary.json", "flight.csv", "events.csv", "config.yaml", "layout.yaml",
                           "conditions.yaml", "report.html"}) {
    const fs::path out = path(std::string("out-") + name);
    fs::create_directories(out / name);
    EXPECT_THAT(refusal(short_flight({"--out", out})),
                AllOf(HasSubstr((out / name).string()), HasSubstr("it is a folder")));
  }
}

TEST_F(FlyCommandTest, ExplainsAPlanWithoutFlying) {
  const Ran ran = run({"fly", "a13", "--explain"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, AllOf(StartsWith("a13: to n13"), HasSubstr("turn 90° left"), HasSubstr("J7→J3"),
                             HasSubstr("hover")));
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 5);
}

TEST_F(FlyCommandTest, AnExplanationHasNoResults) {
  for (const std::string option : {"--json", "--out"}) {
    std::vector<std::string> arguments = {"fly", "a13", "--explain", option};
    if (option == "--out") arguments.push_back(path("out"));
    EXPECT_THAT(refusal(arguments), AllOf(HasSubstr("--explain"), HasSubstr(option), HasSubstr("excludes")));
  }
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(FlyCommandTest, PrintsTheSummaryAsJson) {
  const Ran ran = run(short_flight({"--json"}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const nlohmann::json summary = nlohmann::json::parse(ran.out);
  EXPECT_EQ(summary["outcome"], "arrived");
  EXPECT_EQ(summary["instruction"], "node:q");
  EXPECT_THAT(summary["trajectory_sha256"].get<std::string>(), MatchesRegex("[0-9a-f]+"));
}

TEST_F(FlyCommandTest, PrintsADrawnSpeedForAPerson) {
  const Ran ran =
      run({"fly", "node:q", "--layout", short_flight()[3], "--conditions", "paper..harsh", "--seed", "5"});
  EXPECT_THAT(ran.out, HasSubstr("paper..harsh at 0.2714 m/s, seed 5"));
}

TEST_F(FlyCommandTest, WritesItsFilesAndNoOther) {
  const Ran ran = run(short_flight({"--out", path("a/b")}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path("a/b"))) names.push_back(entry.path().filename());
  std::vector<std::string> expected = {"summary.json", "flight.csv", "events.csv", "config.yaml",
                                       "layout.yaml"};
  if (find_report_page())
    expected.push_back("report.html");
  else
    EXPECT_THAT(ran.err, HasSubstr("report.html is not written"));
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(read_text(path("a/b/layout.yaml")), read_text(path("short.yaml")));
  EXPECT_THAT(read_text(path("a/b/flight.csv")), StartsWith("t_s,"));
  EXPECT_THAT(read_text(path("a/b/events.csv")), StartsWith("t_s,kind,detail\n"));
  EXPECT_EQ(nlohmann::json::parse(read_text(path("a/b/summary.json")))["outcome"], "arrived");
}

TEST_F(FlyCommandTest, RefusesTextThatIsNotUtf8BeforeItFlies) {
  const std::string odd = temp_.write("l\xff.yaml", "name: x\n");
  EXPECT_THAT(refusal({"fly", "a13", "--layout", odd, "--out", path("out")}), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal({"fly", "node:\xc3", "--out", path("out")}), HasSubstr("TARGET"));
  const std::string bytes = temp_.write("bytes.yaml", "name: \"\xff\"\n");
  EXPECT_THAT(refusal({"fly", "a13", "--layout", bytes, "--out", path("out")}), HasSubstr("not UTF-8"));
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(FlyCommandTest, AMissionThatFailsEndsWithOneAndStillWritesEverything) {
  const Ran ran = run(short_flight({"--set", "time_limit_s=3", "--out", path("out")}));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.out, HasSubstr("timeout"));
  for (const char* name : {"summary.json", "flight.csv", "events.csv", "config.yaml"})
    EXPECT_GT(fs::file_size(path("out") / name), 0u) << name;
}

}  // namespace
}  // namespace lineservo::apps
