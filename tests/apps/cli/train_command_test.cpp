#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using TrainCommandTest = ProgramTest;

TEST_F(TrainCommandTest, DoesNotReplaceWhatIsNoFile) {
  const std::vector<std::string> train = {"train-colour", "--samples", "10", "--out"};
  const auto to = [&train](const std::string& out) {
    std::vector<std::string> arguments = train;
    arguments.push_back(out);
    return arguments;
  };
  fs::create_directories(path("folder"));
  EXPECT_THAT(refusal(to("/dev/null")), HasSubstr("/dev/null"));
  EXPECT_THAT(refusal(to(path("folder"))), HasSubstr("it is a folder"));
  EXPECT_THAT(refusal(to("")), HasSubstr("it is a folder"));
  EXPECT_EQ(run(to(path("new.yaml"))).exit_code, 0);
  EXPECT_GT(fs::file_size(path("new.yaml")), 100u);
}

TEST_F(TrainCommandTest, InterruptedItSaysSoAndWritesNothing) {
  const Ran ran = run_and_interrupt({"train-colour", "--samples", "100000", "--out", path("new/m.yaml")},
                                    [this] { return fs::exists(path("new")); });
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "lineservo: train-colour: interrupted; nothing is written\n");
  EXPECT_TRUE(fs::is_empty(path("new")));
}

}  // namespace
}  // namespace lineservo::apps
