#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/image/image_file.h"
#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using testing::read_text;
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

TEST_F(DetectCommandTest, ACameraOfAnotherSizeIsScaledOnlyWhenAsked) {
  const std::string camera = temp_.write("c.yaml", "width_px: 2900\nheight_px: 960\nfocal_px: 1800\n");
  const cv::Mat floor(480, 1450, CV_8UC3, cv::Scalar(120, 120, 120));
  const std::string image = temp_.write("floor.png", png_bytes(floor));
  const std::vector<std::string> plain = {"detect", image, "--camera", camera};
  std::vector<std::string> scaled = plain;
  scaled.push_back("--scale-camera");
  EXPECT_EQ(run(plain).exit_code, 1);
  EXPECT_THAT(run(plain).out, HasSubstr("the image is 1450×480 px, the camera 2900×960"));
  EXPECT_EQ(run(scaled).exit_code, 0);
  EXPECT_THAT(refusal({"detect", "a.png", "--scale-camera"}), HasSubstr("--scale-camera needs a --camera"));
}

TEST_F(DetectCommandTest, ABadImageIsOneLineOnItsOutputAlone) {
  const std::string whole = read_text(LINESERVO_TEST_DATA "/pictures/flight.png");
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{20}, whole.size() / 2}) {
    const std::string bad = temp_.write("bad.png", whole.substr(0, bytes));
    const Ran json = run({"detect", "--json", bad}), text = run({"detect", bad});
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_EQ(json.err, "") << bytes;
    EXPECT_THAT(nlohmann::json::parse(json.out).at("error"), HasSubstr("bad.png: "));
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_EQ(text.err, "") << bytes;
    EXPECT_THAT(text.out, AllOf(HasSubstr("error"), HasSubstr("bad.png")));
  }
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
