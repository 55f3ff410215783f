#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/camera/camera_file.h"
#include "tests/apps/cli/program_test.h"
#include "tests/support/chess_boards.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class CalibrateCommandTest : public ProgramTest {
 protected:
  std::string written(const std::string& name, const cv::Mat& grey) const {
    const std::string pixels(reinterpret_cast<const char*>(grey.data), grey.total());
    return temp_.write(
        name, "P5\n" + std::to_string(grey.cols) + " " + std::to_string(grey.rows) + "\n255\n" + pixels);
  }
  std::string blank(const std::string& name, int width_px = 640) const {
    return written(name, cv::Mat(480, width_px, CV_8UC1, cv::Scalar(120)));
  }
  /// `calibrate` with the images of the first `count` poses.
  std::vector<std::string> command(std::size_t count) const {
    const support::ChessBoards boards({.fx_px = 420.0, .fy_px = 420.0}, 9, 6, 0.025);
    const std::string out = path("out/cam.yaml");
    std::vector<std::string> words = {"calibrate", "--board", "9x6", "--square", "0.025", "--out", out};
    for (std::size_t k = 0; k < count; ++k) {
      const auto [rotation, middle_m] = support::board_poses()[k];
      words.push_back(written("board" + std::to_string(k) + ".pgm", boards.render(rotation, middle_m)));
    }
    return words;
  }
};

TEST_F(CalibrateCommandTest, WritesBothFilesAndNamesImagesWithoutABoard) {
  std::vector<std::string> words = command(6);
  words.push_back(blank("blank.pgm"));
  const Ran ran = run(words);
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("blank.pgm: no board found, left out\n"), HasSubstr("board0.pgm: 0."),
                             HasSubstr("6 of 7 images, error 0.0")));
  EXPECT_NEAR(read_camera(path("out/cam.yaml")).fx_px, 420.0, 0.005 * 420.0);
  EXPECT_NEAR(read_camera(path("out/cam.xml")).fy_px, 420.0, 0.005 * 420.0);
}

TEST_F(CalibrateCommandTest, RefusesWhatGivesNoCameraAndWritesNothing) {
  std::vector<std::string> words = command(2);
  words.push_back(blank("blank.pgm"));
  EXPECT_THAT(refusal(words), AllOf(HasSubstr("in 2 images, at least 3"), HasSubstr("blank.pgm")));
  words.push_back(blank("wide.pgm", 800));
  EXPECT_THAT(refusal(words), HasSubstr("wide.pgm: is 800×480 px, the images before 640×480"));
  words.back() = path("none.pgm");
  EXPECT_THAT(refusal(words), HasSubstr("none.pgm: not a file"));
  EXPECT_TRUE(fs::is_empty(path("out")));
}

TEST_F(CalibrateCommandTest, RefusesWrongUsage) {
  EXPECT_THAT(refusal({"calibrate", "--board", "9by6", "--square", "0.025", "a.png"}),
              HasSubstr("--board '9by6'"));
  EXPECT_THAT(refusal({"calibrate", "--board", "9x6", "--square", "0", "a.png"}), HasSubstr("--square 0"));
  EXPECT_THAT(refusal({"calibrate", "--board", "9x6", "--square", "1", "--out", "a.xml", "a.png"}),
              HasSubstr("names the YAML file"));
}

}  // namespace
}  // namespace lineservo::apps
