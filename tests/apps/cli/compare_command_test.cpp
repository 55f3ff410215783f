#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::read_text;
using CompareCommandTest = ProgramTest;

TEST_F(CompareCommandTest, RefusesComparisonsThatAreNone) {
  EXPECT_THAT(refusal({"compare", "--controllers", "ibvs,lqr"}), HasSubstr("lqr"));
  EXPECT_THAT(refusal({"compare", "--controllers", "ibvs,ibvs"}), HasSubstr("named twice"));
  EXPECT_THAT(refusal({"compare", "--instructions", "a13,a99"}), HasSubstr("a99"));
  EXPECT_THAT(refusal({"compare", "--preset", "none"}), HasSubstr("topology, lfpf, grid-flight"));
  EXPECT_THAT(refusal({"compare", "--preset", "topology", "--layout", "bend"}), HasSubstr("excludes"));
  EXPECT_THAT(refusal({"compare", "--own-speed", "--speeds", "0.1"}), HasSubstr("excludes"));
  EXPECT_THAT(refusal({"compare", "--reference", "pid", "--controllers", "ibvs"}), HasSubstr("--reference"));
  for (const char* bad : {"0", "-1", "x"}) {
    EXPECT_THAT(refusal({"compare", std::string("--runs=") + bad}), HasSubstr("--runs"));
  }
  for (const char* bad : {"0", "-1", "x", "257"}) {
    EXPECT_THAT(refusal({"compare", std::string("--jobs=") + bad}), HasSubstr("from 1 to 256"));
    EXPECT_THAT(refusal({"tune", "pid", std::string("--jobs=") + bad}), HasSubstr("from 1 to 256"));
  }
}

TEST_F(CompareCommandTest, ComparesAndWritesItsThreeFiles) {
  const std::string floor = short_flight()[3];
  const Ran ran = run({"compare", "--instructions", "node:q", "--layout", floor, "--conditions", "ideal",
                       "--controllers", "ibvs,pid", "--runs", "1", "--json", "--out", path("out")});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(read_text(path("out/comparison.json")), ran.out);
  const nlohmann::json json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["settings"]["reference"], "ibvs");
  EXPECT_GE(json["flights"].size(), 2u);
  EXPECT_GT(fs::file_size(path("out/comparison.csv")), 0u);
  EXPECT_GT(fs::file_size(path("out/distribution.csv")), 0u);
}

// report.html and config.yaml of the one would lie beside the figures of the other.
TEST_F(CompareCommandTest, AFolderHoldsAFlightOrAComparison) {
  const std::string floor = short_flight()[3], flight = path("flight"), comparison = path("comparison");
  const std::vector<std::string> compare = {
      "compare",       "--instructions", "node:q", "--layout", floor,      "--conditions", "ideal",
      "--controllers", "ibvs",           "--runs", "1",        "--tuning", "published",    "--out"};
  const auto compare_into = [&compare](const std::string& folder) {
    std::vector<std::string> arguments = compare;
    arguments.push_back(folder);
    return arguments;
  };
  ASSERT_EQ(run(short_flight({"--out", flight})).exit_code, 0);
  ASSERT_EQ(run(compare_into(comparison)).exit_code, 0);
  EXPECT_THAT(refusal(compare_into(flight)),
              HasSubstr("flight: holds the results of a flight (summary.json); allowed: a folder without "
                        "results, or with those of a comparison"));
  EXPECT_THAT(refusal(short_flight({"--out", comparison})),
              HasSubstr("comparison: holds the results of a comparison (comparison.json)"));
  EXPECT_EQ(run(short_flight({"--out", flight})).exit_code, 0);
  EXPECT_EQ(run(compare_into(comparison)).exit_code, 0);
}

TEST_F(CompareCommandTest, RefusesMoreFlightsThanCanBeHeld) {
  EXPECT_THAT(refusal({"compare", "--runs", "1000000", "--controllers", "ibvs", "--tuning", "published"}),
              HasSubstr("--runs 1000000: makes 4000000 flights, 4 for each run; at most 100000 are allowed: "
                        "--runs 25000"));
}

// At whatever point it is.
TEST_F(CompareCommandTest, EndsAtOnceOnCtrlC) {
  const std::string out = path("out");
  const auto asked = [] { return true; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Ran ran = run_and_interrupt(
        {"compare", "--conditions", "paper..harsh", "--runs", "1000", "--out", out}, asked, signal);
    EXPECT_TRUE(ran.exit_code == 1 || ran.exit_code == 128 + signal) << ran.exit_code << ran.err;
    EXPECT_TRUE(!fs::exists(out) || fs::is_empty(out));
  }
}

TEST_F(CompareCommandTest, RefusesASettingThatItsOwnOptionsSet) {
  const std::string set = "speed_m_s=0.5";
  const auto say = AllOf(HasSubstr("--set speed_m_s"), HasSubstr("--speeds"), HasSubstr("--preset"));
  EXPECT_THAT(refusal({"compare", "--speeds", "0.1,0.2", "--set", set}), say);
  EXPECT_THAT(refusal({"compare", "--own-speed", "--set", set}), say);
  EXPECT_THAT(refusal({"compare", "--preset", "topology", "--set", set}), say);
  EXPECT_THAT(refusal({"compare", "--preset", "lfpf", "--set", "servo.improved-carrot.delta_px=60"}),
              HasSubstr("--set servo.improved-carrot.delta_px"));
}

TEST_F(CompareCommandTest, NamesTheOptionThatIsWrong) {
  EXPECT_THAT(
      refusal({"compare", "--speeds", "0.1,5"}),
      AllOf(HasSubstr("--speeds: "), HasSubstr("0.01 to 2"), HasSubstr("'5'"), Not(HasSubstr("--set"))));
  EXPECT_THAT(refusal({"compare", "--speeds", "fast"}), AllOf(HasSubstr("--speeds"), HasSubstr("'fast'")));
  const testing::TempFolder bare;  // a data folder without tuned parameters
  std::filesystem::copy(LINESERVO_TEST_DATA, bare.path(), std::filesystem::copy_options::recursive);
  std::filesystem::remove_all(bare.path() / "tuned");
  ::setenv("LINESERVO_DATA", bare.path().c_str(), 1);
  EXPECT_THAT(refusal({"compare", "--controllers", "pid", "--reference", "pid", "--tuning", "tuned"}),
              HasSubstr("--tuning tuned: no tuned parameters"));
  ::setenv("LINESERVO_DATA", LINESERVO_TEST_DATA, 1);
}

TEST_F(CompareCommandTest, RefusesSeedsThatWouldBeginAgainAtNought) {
  EXPECT_THAT(refusal({"compare", "--seed", "18446744073709551615", "--runs", "2"}),
              AllOf(HasSubstr("--seed 18446744073709551615"), HasSubstr("--runs 2"),
                    HasSubstr("at most 18446744073709551614")));
}

TEST_F(CompareCommandTest, ListsHaveNoEmptyItems) {
  for (const char* option : {"--instructions", "--controllers", "--layout", "--speeds"}) {
    for (const char* list : {"a,,b", ",a", "a,", ",", ""})
      EXPECT_THAT(refusal({"compare", option, list}), AllOf(HasSubstr(option), HasSubstr("empty"))) << list;
  }
}

TEST_F(CompareCommandTest, TakesNothingTwice) {
  EXPECT_THAT(refusal({"compare", "--controllers", "pid,pid"}), HasSubstr("'pid' is named twice"));
  EXPECT_THAT(refusal({"compare", "--speeds", "0.3,0.3"}), HasSubstr("--speeds: '0.3' is named twice"));
}

TEST_F(CompareCommandTest, RefusesAResultNameThatIsNoFileBeforeItFlies) {
  for (const char* name : {"comparison.json", "comparison.csv", "distribution.csv", "report.html"}) {
    const fs::path out = path(std::string("out-") + name);
    fs::create_directories(out / name);
    EXPECT_THAT(refusal({"compare", "--instructions", "node:q", "--layout", short_flight()[3], "--conditions",
                         "ideal", "--controllers", "ibvs", "--runs", "1", "--out", out}),
                HasSubstr("it is a folder"));
  }
}

}  // namespace
}  // namespace lineservo::apps
