#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using TuneCommandTest = ProgramTest;

TEST_F(TuneCommandTest, RefusesSearchesThatAreNone) {
  for (const char* bad : {"0", "-1", "x"})
    EXPECT_THAT(refusal({"tune", "pid", std::string("--budget=") + bad}), HasSubstr("--budget"));
  EXPECT_THAT(refusal({"tune", "lqr"}), HasSubstr("lqr"));
  EXPECT_THAT(refusal({"tune"}), HasSubstr("CONTROLLER"));
}

TEST_F(TuneCommandTest, TakesNothingTwice) {
  EXPECT_THAT(refusal({"tune", "pid", "pid", "--out", path("out")}), HasSubstr("'pid' is named twice"));
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(TuneCommandTest, RefusesAResultNameThatIsNoFileBeforeItFlies) {
  for (const char* name : {"pid.yaml", "tuning.json"}) {
    const fs::path out = path(std::string("out-") + name);
    fs::create_directories(out / name);
    EXPECT_THAT(refusal({"tune", "pid", "--budget", "1", "--out", out}), HasSubstr("it is a folder"));
  }
}

}  // namespace
}  // namespace lineservo::apps
