#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using DetectCommandTest = ProgramTest;

TEST_F(DetectCommandTest, AFilesNameNeedNotBeUtf8) {
  const Ran ran = run({"detect", temp_.write("\xff.png", "no image").string(), "--json"});
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_THAT(nlohmann::json::parse(ran.out).at("error"), HasSubstr("not an image"));
}

TEST_F(DetectCommandTest, TellsOfAFileWhoseNameIsNotUtf8) {
  const Ran ran = run({"detect", path("p\xff.jpg"), "--json"});
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_THAT(nlohmann::json::parse(ran.out)["image"].get<std::string>(), HasSubstr("p\xef\xbf\xbd.jpg"));
}

TEST_F(DetectCommandTest, InterruptedItSaysAfterHowManyImages) {
  std::vector<std::string> arguments = {"detect", "--json"};
  arguments.resize(2000, LINESERVO_TEST_DATA "/pictures/flight.png");
  const Ran ran = run_and_interrupt(
      arguments, [this] { return fs::exists(path("stdout")) && fs::file_size(path("stdout")) > 0; });
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, MatchesRegex("lineservo: detect: interrupted; after [0-9]+ of 1998 images\n"));
  EXPECT_THAT(ran.out, EndsWith("}\n"));
}

}  // namespace
}  // namespace lineservo::apps
