#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using EvaluateCommandTest = ProgramTest;

TEST_F(EvaluateCommandTest, RefusesAResultNameThatIsNoFileBeforeItBegins) {
  for (const char* name : {"evaluation.json", "evaluation.csv"}) {
    const fs::path out = path(std::string("out-") + name);
    fs::create_directories(out / name);
    for (const char* what : {"lines", "junctions"})
      EXPECT_THAT(refusal({"evaluate", what, "--seed", "3", "--out", out}), HasSubstr("it is a folder"));
  }
}

TEST_F(EvaluateCommandTest, ListsHaveEachItemOnceAndNoneThatIsEmpty) {
  EXPECT_THAT(refusal({"evaluate", "lines", "--methods", "stripe,stripe"}),
              HasSubstr("--methods: 'stripe' is named twice"));
  EXPECT_THAT(refusal({"evaluate", "lines", "--levels", "clean,harsh,clean"}),
              HasSubstr("--levels: 'clean' is named twice"));
  for (const char* list : {"stripe,,naive", "stripe,", ""}) {
    EXPECT_THAT(refusal({"evaluate", "lines", "--methods", list}), HasSubstr("--methods")) << list;
    EXPECT_THAT(refusal({"evaluate", "lines", "--levels", list}), HasSubstr("--levels")) << list;
  }
}

TEST_F(EvaluateCommandTest, InterruptedItSaysSoAndWritesNothing) {
  for (const std::string what : {"lines", "junctions"}) {
    std::vector<std::string> arguments = {"evaluate", what, "--out", path(what)};
    if (what == "lines") arguments.insert(arguments.end(), {"--frames", "100000"});
    const Ran ran = run_and_interrupt(arguments, [&] { return fs::exists(path(what)); });
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err, "lineservo: evaluate " + what + ": interrupted; nothing is written\n");
    EXPECT_TRUE(fs::is_empty(path(what)));
  }
}

}  // namespace
}  // namespace lineservo::apps
