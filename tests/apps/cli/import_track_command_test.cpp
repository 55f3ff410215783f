#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/apps/cli/program_test.h"
#include "tests/vehicle/floor/floor_from_above.h"
#include "tests/vehicle/floor/test_layouts.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::read_text;

/// A T of 3 m, 1.2 m up from its middle, lines of 0.1 m.
vehicle::Layout tee() {
  vehicle::Layout layout;
  layout.name = "tee";
  const auto left = vehicle::test::add_node(layout, "left", {0.3, 0.5});
  const auto middle = vehicle::test::add_node(layout, "middle", {1.8, 0.5});
  const auto right = vehicle::test::add_node(layout, "right", {3.3, 0.5});
  const auto top = vehicle::test::add_node(layout, "top", {1.8, 1.7});
  for (const auto& [from, to] : {std::pair{left, middle}, {middle, right}, {middle, top}})
    vehicle::test::add_line(layout, from, to, 0.1);
  return layout;
}

std::string ppm(const cv::Mat& bgr) {
  std::string text = "P6\n" + std::to_string(bgr.cols) + " " + std::to_string(bgr.rows) + "\n255\n";
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x)
      for (const int c : {2, 1, 0}) text += static_cast<char>(bgr.at<cv::Vec3b>(y, x)[c]);
  return text;
}

class ImportTrackCommandTest : public ProgramTest {
 protected:
  std::string picture() const {
    return temp_.write("tee.ppm",
                       ppm(vehicle::test::floor_from_above(tee(), {0.0, 0.0}, 720, 440, 0.005).bgr));
  }
  std::vector<std::string> import(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"import-track", picture(), "--metres-per-pixel", "0.005"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(ImportTrackCommandTest, APictureOfAFloorIsFlownOn) {
  const std::string layout = path("floor/mine.yaml");
  const Ran imported = run(import({"--out", layout, "--bitmap", "--start-disc", "0.06"}));
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_THAT(imported.out, HasSubstr("lineservo fly node:NAME --layout " + layout));
  EXPECT_EQ(read_text(path("floor/tee.ppm")), read_text(path("tee.ppm")));
  EXPECT_THAT(read_text(layout), AllOf(HasSubstr("bitmap: {file: \"tee.ppm\", metres_per_pixel: 0.005}"),
                                       HasSubstr("start: {node: n0, marker_radius_m: 0.06}")));
  const Ran flown = run({"fly", "node:n2", "--layout", layout, "--json", "--out", path("flown")});
  ASSERT_EQ(flown.exit_code, 0) << flown.err;
  const nlohmann::json summary = nlohmann::json::parse(flown.out);
  EXPECT_EQ(summary["outcome"], "arrived");
  EXPECT_LT(summary["tracking"]["rmse_m"], 0.02);
  EXPECT_NEAR(summary["target"]["y_m"], 1.7, 0.02);
  EXPECT_TRUE(fs::exists(path("flown/tee.ppm"))) << "the folder flies again by itself";
  fs::copy(path("flown"), path("flown-on"), fs::copy_options::recursive);
  ASSERT_EQ(run(short_flight({"--out", path("flown-on")})).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("flown-on/tee.ppm"))) << "another floor, without a bitmap";
  fs::remove_all(path("floor"));
  const Ran again = run({"fly", "--config", path("flown/config.yaml"), "--json"});
  EXPECT_EQ(nlohmann::json::parse(again.out)["trajectory_sha256"], summary["trajectory_sha256"]) << again.err;
}

TEST_F(ImportTrackCommandTest, TheCommandThatItSuggestsIsForAShell) {
  const Ran ran = run(import({"--out", path("my floor.yaml")}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("--layout '" + path("my floor.yaml").string() + "'"));
}

TEST_F(ImportTrackCommandTest, TheLinesArePaintedUnlessTheImageIsTheFloor) {
  const Ran ran = run(import({"--out", path("floor/mine.yaml")}));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(read_text(path("floor/mine.yaml")), ::testing::Not(HasSubstr("bitmap:")));
  EXPECT_FALSE(fs::exists(path("floor/tee.ppm")));
}

TEST_F(ImportTrackCommandTest, AnImageBesideTheLayoutStaysAsItIs) {
  const std::string image = picture(), before = read_text(image);
  const Ran ran =
      run({"import-track", image, "--metres-per-pixel", "0.005", "--out", path("m.yaml"), "--bitmap"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(read_text(image), before);
}

TEST_F(ImportTrackCommandTest, RefusesInOneLineAndLeavesNothing) {
  const std::string out = path("floor/m.yaml");
  EXPECT_THAT(refusal(import({"--out", out, "--start-disc", "-1"})), HasSubstr("--start-disc: must be"));
  EXPECT_THAT(refusal(import({"--out", out, "--start-disc", "3"})), HasSubstr("--start-disc: must be"));
  EXPECT_THAT(refusal(import({"--out", path("m.txt"), "--bitmap"})), HasSubstr("must end in .yaml"));
  const std::string odd = temp_.write("tee.image", read_text(path("tee.ppm")));
  EXPECT_THAT(refusal({"import-track", odd, "--metres-per-pixel", "0.005", "--out", out, "--bitmap"}),
              AllOf(HasSubstr("tee.image"), HasSubstr(".png")));
  EXPECT_FALSE(fs::exists(path("floor")));
}

TEST_F(ImportTrackCommandTest, WhatGivesNoLayoutLeavesTheOldOneThere) {
  fs::create_directories(path("floor"));
  temp_.write("floor/mine: b#c.yaml", "old");
  const Ran named = run(import({"--out", path("floor/mine: b#c.yaml")}));
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_THAT(named.err, HasSubstr("gives no layout that can be flown"));
  EXPECT_EQ(read_text(path("floor/mine: b#c.yaml")), "old");
}

TEST_F(ImportTrackCommandTest, AnotherImageOfTheSameNameStays) {
  fs::create_directories(path("floor"));
  temp_.write("floor/tee.ppm", "another");
  const Ran ran = run(import({"--out", path("floor/mine.yaml"), "--bitmap"}));
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("another image of this name is there"));
  EXPECT_EQ(read_text(path("floor/tee.ppm")), "another");
  EXPECT_FALSE(fs::exists(path("floor/mine.yaml")));
}

}  // namespace
}  // namespace lineservo::apps
