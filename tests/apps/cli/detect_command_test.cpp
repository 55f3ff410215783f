#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
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

}  // namespace
}  // namespace lineservo::apps
