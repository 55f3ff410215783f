#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core/mat.hpp>
#include <sstream>

#include "apps/image/image_file.h"
#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::read_text;
using ::testing::StartsWith;

/// The rows of a CSV text by the columns' names, of those columns alone.
std::vector<std::string> columns(const std::string& csv, const std::vector<std::string>& names) {
  std::stringstream lines(csv);
  std::vector<std::size_t> places;
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) {
    std::stringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (places.empty()) {
      for (const std::string& name : names)
        places.push_back(static_cast<std::size_t>(std::find(row.begin(), row.end(), name) - row.begin()));
    }
    std::string text;
    for (const std::size_t place : places) text += row.at(place) + ",";
    rows.push_back(text);
  }
  return rows;
}

class WatchProgram : public ProgramTest {
 protected:
  std::vector<std::string> small_flight(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = short_flight(
        {"--set", "camera.width_px=320", "--set", "camera.height_px=240", "--set", "camera.focal_px=160"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// Images of a yellow stripe, of these widths.
  std::string images(const std::vector<int>& widths_px) const {
    const fs::path folder = path("images");
    fs::create_directory(folder);
    for (std::size_t k = 0; k < widths_px.size(); ++k) {
      cv::Mat image(480, widths_px[k], CV_8UC3, cv::Scalar(110, 110, 110));
      image(cv::Rect(widths_px[k] / 2 - 40, 0, 80, 480)).setTo(cv::Scalar(0, 200, 220));
      std::ofstream(folder / ("f" + std::to_string(k) + ".png"), std::ios::binary) << png_bytes(image);
    }
    return folder.string();
  }
};

// flight.csv and watch.csv write what both have alike.
TEST_F(WatchProgram, ARecordedFlightIsSeenAsItWasFlown) {
  const std::string folder = path("flight");
  ASSERT_EQ(run(small_flight({"--record", "--out", folder})).exit_code, 0);
  const Ran watched = run({"watch", folder});
  EXPECT_EQ(watched.exit_code, 0) << watched.err;
  EXPECT_EQ(watched.err, "");
  const std::vector<std::string> both = {"t_s",        "line_rho", "line_theta_rad", "junction_x",
                                         "junction_y", "code_raw", "code_held",      "code_smoothed"};
  const std::vector<std::string> flown = columns(read_text(path("flight/flight.csv")), both);
  EXPECT_GT(flown.size(), 200u);
  EXPECT_EQ(columns(watched.out, both), flown);

  EXPECT_THAT(refusal({"watch", folder, "--height", "0.5"}), HasSubstr("--height does not go with"));
  EXPECT_THAT(refusal({"watch", folder, "--conditions", "paper"}), HasSubstr("use --set"));
  EXPECT_THAT(refusal({"watch", folder, "--record", folder}),
              HasSubstr("would replace " + folder + ", which is read"));
}

TEST_F(WatchProgram, ASimulatedFlightIsWatchedAsItFlies) {
  const Ran ran = run({"watch", "sim:warehouse/a13", "--frames", "12", "--controllers", "pid,ibvs"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 13);
  EXPECT_THAT(ran.out, AllOf(StartsWith("t_s,frame,found,"), HasSubstr(",pid.forward_m_s,"),
                             HasSubstr(",ibvs.forward_m_s,")));
}

TEST_F(WatchProgram, ImagesGoToAFileAndARecordingThatReplays) {
  const std::string source = images({640, 640, 640}), out = path("seen.csv"), record = path("kept");
  const Ran ran = run({"watch", source, "--height", "0.7", "--rate", "20", "--controllers", "ibvs,grid",
                       "--out", out, "--record", record});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  const std::vector<std::string> rows = columns(read_text(out), {"t_s", "frame", "found", "height_m"});
  EXPECT_EQ(rows, (std::vector<std::string>{"t_s,frame,found,height_m,", "0.0000,0,1,0.700000,",
                                            "0.0500,1,1,0.700000,", "0.1000,2,1,0.700000,"}));
  EXPECT_EQ(read_text(path("kept/watch.csv")), read_text(out));
  EXPECT_EQ(run({"replay", record}).exit_code, 0);
}

TEST_F(WatchProgram, AChangeOfSizeKeepsWhatCameBefore) {
  const std::string out = path("seen.csv");
  const Ran ran = run({"watch", images({640, 640, 320}), "--out", out});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, AllOf(HasSubstr("the size may not change"), HasSubstr("watched 2 frames until then")));
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1);
  EXPECT_EQ(columns(read_text(out), {"frame"}).size(), 3u);
}

TEST_F(WatchProgram, AnImageThatCannotBeReadKeepsWhatCameBefore) {
  const std::string source = images({640, 640});
  for (const char* content : {"no image", "P6\n60000 60000\n255\n"}) {  // the second is too large, it says
    std::ofstream(path("images/g.png")) << content;
    const Ran ran = run({"watch", source});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.err, HasSubstr("g.png: is not an image that can be read; watched 2 frames until then"));
    EXPECT_EQ(columns(ran.out, {"frame"}).size(), 3u);
  }
}

TEST_F(WatchProgram, HeightsFromAFileMustCoverTheFrames) {
  const fs::path heights = temp_.write("h.csv", "t_s,height_m\n0,0.5\n0.12,0.8\n");
  const Ran ran = run({"watch", images({640, 640, 640}), "--rate", "10", "--height", heights});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, AllOf(HasSubstr("h.csv: holds 0.000 to 0.120 s; there is a frame at 0.200 s"),
                             HasSubstr("watched 2 frames")));
  EXPECT_EQ(columns(ran.out, {"height_m"}).back(), "0.750000,");
}

TEST_F(WatchProgram, ACameraOfAnotherSizeIsRefusedUnlessScaled) {
  const std::string source = images({640});
  const fs::path camera = temp_.write("c.yaml", "width_px: 1280\nheight_px: 960\nfocal_px: 640\n");
  EXPECT_THAT(refusal({"watch", source, "--camera", camera}), HasSubstr("1280"));
  EXPECT_EQ(run({"watch", source, "--camera", camera, "--scale-camera"}).exit_code, 0);
  EXPECT_THAT(refusal({"watch", source, "--scale-camera"}), HasSubstr("needs a --camera"));
  EXPECT_THAT(refusal({"watch", source, "--set", "camera.width_px=320"}), HasSubstr("give a camera file"));
}

TEST_F(WatchProgram, RefusesWhatIsNotThere) {
  const std::string source = images({640});
  EXPECT_THAT(refusal({"watch"}), HasSubstr("SOURCE"));
  EXPECT_THAT(refusal({"watch", "/dev/no-camera"}), HasSubstr("/dev/no-camera: cannot be opened"));
  EXPECT_THAT(refusal({"watch", path("none.mp4")}), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal({"watch", temp_.write("noise.avi", "no video")}), HasSubstr("is not a video"));
  EXPECT_THAT(refusal({"watch", temp_.path()}), HasSubstr("no image"));
  EXPECT_THAT(refusal({"watch", "sim:nowhere/a13"}), HasSubstr("no layout 'nowhere'"));
  EXPECT_THAT(refusal({"watch", "sim:warehouse/a99"}), HasSubstr("a99"));
  EXPECT_THAT(refusal({"watch", source, "--controllers", "ibvs,other"}), HasSubstr("unknown controller"));
  EXPECT_THAT(refusal({"watch", source, "--controllers", "ibvs,ibvs"}), HasSubstr("ibvs"));
  for (const char* height : {"0", "-1", "4"})
    EXPECT_THAT(refusal({"watch", source, "--height", height}), HasSubstr("--height")) << height;
  EXPECT_THAT(refusal({"watch", source, "--height", "tall"}), HasSubstr("tall: not a file"));
  EXPECT_THAT(refusal({"watch", source, "--rate", "0"}), HasSubstr("--rate '0'"));
  EXPECT_THAT(refusal({"watch", source, "--frames", "0"}), HasSubstr("--frames"));
  EXPECT_THAT(refusal({"watch", source, "--out", temp_.path()}), HasSubstr("it is a folder"));
}

TEST_F(WatchProgram, DoesNotReplaceWhatItReads) {
  const std::string source = images({640, 640}), frame = path("images/f0.png").string();
  const std::string heights = temp_.write("h.csv", "t_s,height_m\n0,0.5\n9,0.5\n");
  fs::create_directories(path("kept"));
  const std::string camera =
      temp_.write("kept/camera.yaml", "width_px: 640\nheight_px: 480\nfocal_px: 320\n");
  for (const std::string& read : {frame, heights, camera})
    EXPECT_THAT(refusal({"watch", source, "--height", heights, "--camera", camera, "--out", read}),
                HasSubstr("--out " + read + ": is there already and no table of watch"));
  EXPECT_THAT(refusal({"watch", source, "--camera", camera, "--record", path("kept")}),
              HasSubstr("would replace " + camera + ", which is read"));
  EXPECT_THAT(read_text(camera), StartsWith("width_px"));
  const std::string out = path("seen.csv"), record = path("recording");
  for (int k = 0; k < 2; ++k) {
    const Ran ran = run({"watch", source, "--out", out, "--record", record});
    EXPECT_EQ(ran.exit_code, 0) << ran.err << "also over an earlier table and recording";
  }
  EXPECT_THAT(refusal({"watch", record + "/frames", "--record", record}), HasSubstr("which is read"));
  EXPECT_THAT(refusal({"watch", record + "/frames/%06d.png", "--record", record}),
              HasSubstr("which is read"));
}

TEST_F(WatchProgram, AFullDiskIsToldAndLeavesNothing) {
  const std::string record = path("kept");
  const Ran ran = run({"watch", images({640, 640}), "--record", record}, 1000);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("cannot be written"));
  EXPECT_TRUE(fs::is_empty(record));
}

/// Ctrl-C closes the files whole, and so does whatever else asks the program to end.
class InterruptedWatch : public WatchProgram, public ::testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(By, InterruptedWatch, ::testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_P(InterruptedWatch, KeepsWhatWasGot) {
  const std::string out = path("seen.csv"), record = path("kept");
  const auto has_begun = [&] {
    if (!fs::exists(record)) return false;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(record))
      if (entry.path().filename() == "000003.png") return true;
    return false;
  };
  const Ran ran = run_and_interrupt({"watch", "sim:warehouse/a13", "--out", out, "--record", record},
                                    has_begun, GetParam());
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("watch: interrupted after"));
  EXPECT_GT(columns(read_text(out), {"frame"}).size(), 4u);
  const Ran replayed = run({"replay", record});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  for (const fs::directory_entry& entry : fs::directory_iterator(record))
    EXPECT_THAT(entry.path().filename().string(), ::testing::Not(HasSubstr(".part-")));
}

}  // namespace
}  // namespace lineservo::apps
