// The command line as a whole; each sub-command has a file of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "apps/version.h"
#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(ProgramTest, RefusesWhatIsNoCommandLine) {
  EXPECT_THAT(refusal({}), HasSubstr("subcommand is required"));
  EXPECT_THAT(refusal({"flyy"}), HasSubstr("lineservo --help"));
  EXPECT_THAT(refusal({"fly", "a13", "--sped", "1"}), HasSubstr("--sped"));
  EXPECT_THAT(refusal({"fly", "a13", "a14"}), HasSubstr("a14"));
  EXPECT_THAT(refusal({"fly", "a13", "--layout"}), HasSubstr("--layout"));
  EXPECT_THAT(refusal({"layouts", "x"}), HasSubstr("x"));
}

TEST_F(ProgramTest, RefusesNumbersThatAreNone) {
  for (const char* speed : {"fast", "nan", "inf", "0", "-1", "2.01", "", "0.1x", " 0.1", "1e999"})
    EXPECT_THAT(refusal({"fly", "a13", "--speed", speed}), HasSubstr("speed")) << speed;
  for (const char* seed : {"one", "1.5", "-1", "18446744073709551616", "", "1x", "nan"}) {
    EXPECT_THAT(refusal({"fly", "a13", "--seed", seed}), HasSubstr("seed")) << seed;
    for (const char* what : {"lines", "junctions"})
      EXPECT_THAT(refusal({"evaluate", what, "--seed", seed}), HasSubstr("seed")) << seed;
    EXPECT_THAT(refusal({"train-colour", "--out", path("m.yaml"), "--seed", seed}), HasSubstr("seed"))
        << seed;
  }
  for (const char* count : {"", "-1", "0", "1.5", "nan", "inf", "12x", "100001", "99999999999999999999"}) {
    EXPECT_THAT(refusal({"evaluate", "lines", "--frames", count}), HasSubstr("--frames")) << count;
    EXPECT_THAT(refusal({"train-colour", "--out", path("m.yaml"), "--samples", count}),
                HasSubstr("--samples"))
        << count;
  }
  EXPECT_FALSE(fs::exists(path("m.yaml")));
}

TEST_F(ProgramTest, HelpIsEverywhereAndQuick) {
  const auto begin = std::chrono::steady_clock::now();
  const Ran fly = run({"fly", "--help"});
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 0.5);
  EXPECT_EQ(fly.exit_code, 0);
  EXPECT_EQ(fly.err, "");
  for (const char* word : {"TARGET", "--controller", "--layout", "--conditions", "--speed", "--seed", "--set",
                           "--config", "--land", "--explain", "--out", "--json"})
    EXPECT_THAT(fly.out, HasSubstr(word));
  for (const char* command : {"fly", "compare", "tune", "layouts", "controllers", "conditions", "test"}) {
    EXPECT_THAT(run({"--help"}).out, HasSubstr(command));
    EXPECT_EQ(run({command, "--help"}).exit_code, 0) << command;
  }
}

TEST_F(ProgramTest, TellsItsVersion) {
  const Ran ran = run({"--version"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out, std::string(kVersion) + "\n");
}

TEST_F(ProgramTest, AFullOutputIsToldInOneLine) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"layouts"},
                                                    {"--help"},
                                                    {"fly", "a13", "--explain"},
                                                    {"--version"},
                                                    short_flight({"--json"}),
                                                    {"detect", "--json", "/nowhere.jpg"}}) {
    const Ran ran = run_to("/dev/full", fs::current_path(), arguments, 0);
    EXPECT_EQ(ran.exit_code, 2) << arguments.front();
    const bool tells_progress = arguments.front() == "fly" && arguments.back() == "--json";
    if (!tells_progress) {
      EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    }
    EXPECT_THAT(ran.err, HasSubstr("lineservo: standard output cannot be written")) << arguments.front();
  }
}

TEST_F(ProgramTest, NamesACommandThatItDoesNotKnow) {
  EXPECT_THAT(refusal({"flyy", "a13"}), AllOf(HasSubstr("'flyy'"), HasSubstr("fly, "), HasSubstr("layouts")));
  EXPECT_THAT(refusal({"evaluate", "circles"}), AllOf(HasSubstr("'circles'"), HasSubstr("lines, junctions")));
  EXPECT_THAT(refusal({}), HasSubstr("--help"));
}

}  // namespace
}  // namespace lineservo::apps
