#include "apps/recording/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/text_file.h"
#include "apps/image/image_file.h"
#include "apps/output/sha256.h"
#include "apps/recording/digest.h"
#include "tests/apps/recording/recorded_flight.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

/// One flight for all tests; each changes a copy of its own.
class ReplayTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    flown_ = new testing::TempFolder;
    testing::record_flight(flown_->path(), testing::short_request());
  }
  static void TearDownTestSuite() {
    delete flown_;
    flown_ = nullptr;
  }
  ReplayTest() {
    fs::copy(flown_->path(), folder_, fs::copy_options::recursive);
    recording_ = read_recording(folder_);
  }

  std::string difference() const { return replay(read_recording(folder_)).value_or("none"); }
  RecordedTick& tick(std::size_t row) { return recording_.ticks.at(row); }
  fs::path frame(std::size_t row) { return folder_ / kRecordingFrames / tick(row).frame; }
  /// The line is painted over.
  void spoil_frame(std::size_t row) {
    cv::Mat image = read_image(frame(row));
    image(cv::Rect(100, 0, 120, 240)).setTo(cv::Scalar::all(90));
    std::ofstream(frame(row), std::ios::binary) << png_bytes(image);
  }

  const testing::TempFolder temp_;
  const fs::path folder_ = temp_.path() / "flight";
  Recording recording_;

 private:
  inline static testing::TempFolder* flown_ = nullptr;
};

TEST_F(ReplayTest, AnUntouchedRecordingIsTheSameToTheLastBit) {
  ASSERT_GT(recording_.ticks.size(), 100u);
  EXPECT_EQ(difference(), "none");
}

TEST_F(ReplayTest, OneChangedLevelOfOnePixelIsNamed) {
  cv::Mat image = read_image(frame(50));
  image.at<cv::Vec3b>(0, 0)[0] ^= 1;
  std::ofstream(frame(50), std::ios::binary) << png_bytes(image);
  EXPECT_EQ(difference().substr(0, 7), "tick 50");
  EXPECT_THAT(difference(), HasSubstr("frame frames/000050.png is not the one that was recorded"));
}

TEST_F(ReplayTest, TheFirstDifferenceIsNamed) {
  spoil_frame(70);
  spoil_frame(60);
  EXPECT_THAT(difference(), HasSubstr("frames/000060.png"));
}

TEST_F(ReplayTest, AFrameWithABrokenEndOrNoneAtAllIsNamed) {
  fs::resize_file(frame(50), fs::file_size(frame(50)) - 1);
  EXPECT_THAT(difference(), HasSubstr("frame frames/000050.png is not the one"));
  fs::remove(frame(40));
  EXPECT_THAT(difference(), HasSubstr("frame frames/000040.png is missing"));
}

// Whoever changes the hash along with the frame is told by what is seen in it.
TEST_F(ReplayTest, AChangedFrameWithItsHashGivesOtherFeatures) {
  spoil_frame(90);
  tick(90).frame_sha256 = sha256_hex(read_bytes(frame(90)));
  testing::write_table(recording_);
  EXPECT_THAT(difference(), AllOf(HasSubstr("tick 90"), HasSubstr("ibvs sees other features")));
}

TEST_F(ReplayTest, AChangedEstimateIsNamed) {
  tick(80).input.estimate.v_H_m_s.y() += 1e-12;
  testing::write_table(recording_);
  EXPECT_THAT(difference(), AllOf(HasSubstr("tick 80"), HasSubstr("the estimates are not those")));
}

TEST_F(ReplayTest, AChangedEstimateWithItsHashGivesAnotherCommand) {
  RecordedTick& changed = tick(100);
  changed.input.estimate.height_m += 0.01;
  changed.estimates_sha256 = digest(changed.input);
  testing::write_table(recording_);
  EXPECT_THAT(difference(), AllOf(HasSubstr("tick 100"), HasSubstr("ibvs gives another command")));
}

TEST_F(ReplayTest, AChangedCommandIsNamed) {
  tick(80).outputs.front().command[1] += 1e-12;
  testing::write_table(recording_);
  EXPECT_THAT(difference(), AllOf(HasSubstr("tick 80"), HasSubstr("the command of ibvs is not the one")));
}

TEST_F(ReplayTest, ARowThatIsLeftOutAtTheEndIsNamed) {
  recording_.ticks.pop_back();
  testing::write_table(recording_);
  EXPECT_THAT(difference(), HasSubstr("were recorded"));
}

TEST_F(ReplayTest, AnotherGainGivesAnotherCommand) {
  FlightRequest request = recording_.request;
  apply_override(request, "servo.ibvs.gain_at_zero=1.234");
  std::ofstream(folder_ / "config.yaml") << config_text(request);
  EXPECT_THAT(difference(), HasSubstr("ibvs gives another command"));
}

// Open loop the same law says the same, and another law something else.
TEST_F(ReplayTest, OtherControllersSeeTheSameFrames) {
  std::size_t same = 0, other = 0;
  ReplayOptions options;
  options.others = {"ibvs", "pid"};
  options.on_tick = [&](const ReplayedTick& replayed) {
    const std::string recorded = replayed.recorded.outputs.front().command_sha256;
    same += digest(row_of(replayed.others[0])) == recorded ? 1 : 0;
    other += digest(row_of(replayed.others[1])) != recorded ? 1 : 0;
    return true;
  };
  EXPECT_EQ(replay(recording_, options), std::nullopt);
  EXPECT_EQ(same, recording_.ticks.size());
  EXPECT_GT(other, recording_.ticks.size() / 2);
}

TEST_F(ReplayTest, WhatIsNoRecordingIsRefused) {
  const auto reading = [&] { return testing::complaint([&] { read_recording(folder_); }); };
  std::ofstream(folder_ / kRecordingTable, std::ios::app) << "1,2\n";
  EXPECT_THAT(reading(), AllOf(HasSubstr("recording.csv:"), HasSubstr("is missing")));
  std::ofstream(folder_ / kRecordingTable) << "t_s\n";
  EXPECT_THAT(reading(), HasSubstr("recording.csv:1: is not the header"));
  std::ofstream(folder_ / kRecordingInfo) << "{}";
  EXPECT_THAT(reading(), HasSubstr("recording.json: is not what a recording has"));
  fs::remove(folder_ / kRecordingInfo);
  EXPECT_THAT(reading(), HasSubstr("is not the folder of a recording"));
}

// Ticks without frames, and features and estimates that are no numbers, replay as well.
TEST(Replay, AFlightWithFaultsIsTheSameToTheLastBit) {
  const testing::TempFolder temp;
  testing::record_flight(
      temp.path(),
      testing::short_request({"faults.camera_silent.start_s=8", "faults.camera_silent.duration_s=1",
                              "faults.law_nan.start_s=9.5", "faults.law_nan.duration_s=0.3"}));
  const Recording recording = read_recording(temp.path());
  EXPECT_TRUE(std::any_of(recording.ticks.begin(), recording.ticks.end(),
                          [](const RecordedTick& tick) { return !tick.input.has_frame; }));
  EXPECT_EQ(replay(recording), std::nullopt);
}

}  // namespace
}  // namespace lineservo::apps
