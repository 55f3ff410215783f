#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
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
    EXPECT_THAT(refusal({"compare", std::string("--jobs=") + bad}), HasSubstr("--jobs"));
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

TEST_F(CompareCommandTest, TakesNothingTwice) {
  EXPECT_THAT(refusal({"compare", "--controllers", "pid,pid"}), HasSubstr("'pid' is named twice"));
  EXPECT_THAT(refusal({"compare", "--speeds", "0.3,0.3"}), HasSubstr("--speeds: '0.3' is named twice"));
}

TEST_F(CompareCommandTest, RefusesAResultNameThatIsNoFileBeforeItFlies) {
  for (const char* name : {"comparison.json", "comparison.csv", "distribution.csv"}) {
    const fs::path out = path(std::string("out-") + name);
    fs::create_directories(out / name);
    EXPECT_THAT(refusal({"compare", "--instructions", "node:q", "--layout", short_flight()[3], "--conditions",
                         "ideal", "--controllers", "ibvs", "--runs", "1", "--out", out}),
                HasSubstr("it is a folder"));
  }
}

}  // namespace
}  // namespace lineservo::apps
