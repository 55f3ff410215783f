// fly --video, by the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "tests/apps/cli/program_test.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::read_text;
using FlyVideoTest = ProgramTest;

nlohmann::json summary_in(const fs::path& folder) {
  return nlohmann::json::parse(read_text(folder / "summary.json"));
}

TEST_F(FlyVideoTest, NeedsAFolder) {
  EXPECT_THAT(refusal({"fly", "a13", "--video"}), AllOf(HasSubstr("--video"), HasSubstr("--out")));
}

TEST_F(FlyVideoTest, TheVideoIsTheWholeFlightInRealTimeAndChangesNothing) {
  const Ran with = run(short_flight({"--video", "--record", "--out", path("with")}));
  const Ran without = run(short_flight({"--out", path("without")}));
  EXPECT_EQ(with.exit_code, 0) << with.err;
  const nlohmann::json summary = summary_in(path("with"));
  EXPECT_EQ(summary["trajectory_sha256"], summary_in(path("without"))["trajectory_sha256"]);
  EXPECT_FALSE(fs::exists(path("without/flight.mp4")));
  EXPECT_TRUE(fs::exists(path("with/frames")));

  cv::VideoCapture video(path("with/flight.mp4").string());
  ASSERT_TRUE(video.isOpened());
  EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 30.0, 1e-3);
  const double seconds = video.get(cv::CAP_PROP_FRAME_COUNT) / 30.0;
  EXPECT_NEAR(seconds, summary["duration_s"].get<double>(), 0.2);
  cv::Mat frame;
  ASSERT_TRUE(video.read(frame));
  EXPECT_EQ(frame.size(), cv::Size(854, 480));
}

TEST_F(FlyVideoTest, AFlightWithoutVideoTakesTheEarlierFlightsAway) {
  run(short_flight({"--video", "--out", path("out"), "--set", "time_limit_s=2"}));
  EXPECT_TRUE(fs::exists(path("out/flight.mp4")));
  run(short_flight({"--out", path("out")}));
  EXPECT_FALSE(fs::exists(path("out/flight.mp4")));
  EXPECT_EQ(summary_in(path("out"))["outcome"], "arrived");
}

TEST_F(FlyVideoTest, AVideoOfTheUsersOwnIsNotTouched) {
  fs::create_directories(path("out"));
  temp_.write("out/flight.mp4", "mine");
  EXPECT_THAT(refusal(short_flight({"--video", "--out", path("out")})), HasSubstr("flight.mp4"));
  EXPECT_THAT(refusal(short_flight({"--out", path("out")})),
              HasSubstr("flight.mp4"));  // the next would remove it
  EXPECT_EQ(read_text(path("out/flight.mp4")), "mine");
}

TEST_F(FlyVideoTest, AnInterruptedFlightHasItsVideoAsFarAsItCame) {
  const auto has_begun = [this] {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(path("out"), error))
      if (entry.file_size() > 20000) return true;
    return false;
  };
  const Ran ran = run_and_interrupt({"fly", "a53", "--video", "--out", path("out")}, has_begun);
  EXPECT_EQ(ran.exit_code, 1) << ran.err;
  EXPECT_EQ(summary_in(path("out"))["outcome"], "aborted");
  EXPECT_TRUE(cv::VideoCapture(path("out/flight.mp4").string()).isOpened());
}

TEST_F(FlyVideoTest, AFullDiskIsOneErrorAndLeavesNothing) {
  const Ran ran = run(short_flight({"--video", "--out", path("out")}), 30000);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_THAT(ran.err, HasSubstr("flight.mp4: cannot be written whole"));
  EXPECT_TRUE(fs::is_empty(path("out")));
}

}  // namespace
}  // namespace lineservo::apps
