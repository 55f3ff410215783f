#include "apps/video/video_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "tests/apps/small_disk.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using testing::SmallDisk;
using testing::TempFolder;

constexpr double kRate_hz = 10.0;
constexpr const char* kOwner = "config.yaml";
const cv::Size kSize(320, 240);
const VideoCodec kUnknown{"Nonesuch", "zzzz", ".mp4"};

/// A picture that is unlike those of other numbers.
cv::Mat picture(int number) {
  cv::Mat bgr(kSize, CV_8UC3, cv::Scalar(40.0 + 10.0 * number, 120.0, 200.0 - 10.0 * number));
  cv::rectangle(bgr, {20 * number, 60, 40, 120}, {255, 255, 255}, cv::FILLED);
  return bgr;
}

std::vector<cv::Mat> frames_of(const fs::path& file) {
  cv::VideoCapture video(file.string());
  EXPECT_TRUE(video.isOpened()) << file;
  std::vector<cv::Mat> frames;
  cv::Mat frame;
  while (video.read(frame)) frames.push_back(frame.clone());
  return frames;
}

/// The mean difference of a pixel's colour: what a lossy video may change.
double difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / (3.0 * static_cast<double>(a.total()));
}

void publish(ResultFolder& folder, VideoFile& video) {
  video.finish();
  folder.write("seal", "x");
  folder.publish();
}

TEST(VideoFile, EveryPictureIsInItInOrder) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  VideoFile video(folder, "flight", kOwner, kRate_hz, kSize);
  EXPECT_EQ(video.name(), "flight.mp4");
  EXPECT_EQ(video.note(), "");
  for (int k = 0; k < 12; ++k) video.add(3.0 + k / kRate_hz, picture(k));
  EXPECT_FALSE(fs::exists(temp.path() / "flight.mp4"));
  publish(folder, video);
  const std::vector<cv::Mat> frames = frames_of(temp.path() / "flight.mp4");
  ASSERT_EQ(frames.size(), 12u);
  for (int k = 0; k < 12; ++k) {
    const cv::Mat& frame = frames[static_cast<std::size_t>(k)];
    ASSERT_EQ(frame.size(), kSize);
    EXPECT_LT(difference(frame, picture(k)), 4.0) << k;
    EXPECT_GT(difference(frame, picture(k + 1)), 6.0) << k;
  }
  EXPECT_NEAR(cv::VideoCapture((temp.path() / "flight.mp4").string()).get(cv::CAP_PROP_FPS), kRate_hz, 1e-3);
}

TEST(VideoFile, APictureIsShownUntilTheNextOnesTime) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  VideoFile video(folder, "flight", kOwner, kRate_hz, kSize);
  video.add(0.0, picture(0));
  video.add(0.1, picture(1));
  video.add(0.11, picture(9));
  video.add(0.4, picture(2));
  publish(folder, video);
  const std::vector<cv::Mat> frames = frames_of(temp.path() / "flight.mp4");
  ASSERT_EQ(frames.size(), 5u);
  const int shown[] = {0, 1, 9, 9, 2};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_LT(difference(frames[k], picture(shown[k])), 4.0) << k;
}

TEST(VideoFile, TheNextCodecIsTakenWhereTheFirstIsNotInstalledAndSaidSo) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  VideoFile video(folder, "flight", kOwner, kRate_hz, kSize, {kUnknown, video_codecs().back()});
  EXPECT_EQ(video.name(), "flight.avi");
  EXPECT_EQ(video.note(), "flight.avi is Motion JPEG: the installed codecs do not write Nonesuch");
  for (int k = 0; k < 5; ++k) video.add(k / kRate_hz, picture(k));
  publish(folder, video);
  EXPECT_FALSE(fs::exists(temp.path() / "flight.mp4"));
  const std::vector<cv::Mat> frames = frames_of(temp.path() / "flight.avi");
  ASSERT_EQ(frames.size(), 5u);
  EXPECT_LT(difference(frames.back(), picture(4)), 4.0);
}

TEST(VideoFile, EachCodecThatIsTriedWritesVideos) {
  for (const VideoCodec& codec : video_codecs()) {
    const TempFolder temp;
    ResultFolder folder(temp.path());
    VideoFile video(folder, "flight", kOwner, kRate_hz, kSize, {codec});
    for (int k = 0; k < 5; ++k) video.add(k / kRate_hz, picture(k));
    publish(folder, video);
    EXPECT_EQ(frames_of(temp.path() / ("flight" + codec.ending)).size(), 5u) << codec.name;
  }
}

TEST(VideoFile, WithoutAnyCodecItIsRefusedAndNothingIsLeft) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  EXPECT_THAT(complaint([&] { VideoFile(folder, "flight", kOwner, kRate_hz, kSize, {kUnknown}); }),
              AllOf(HasSubstr("flight.mp4: cannot be written"), HasSubstr("320×240")));
  EXPECT_EQ(temp.count(), 0u);
}

TEST(VideoFile, AFullDiskIsOneErrorAndLeavesNothing) {
  for (const VideoCodec& codec : video_codecs()) {
    const TempFolder temp;
    std::string message;
    {
      const SmallDisk disk(8192);
      message = complaint([&] {
        ResultFolder folder(temp.path());
        VideoFile video(folder, "flight", kOwner, kRate_hz, kSize, {codec});
        cv::Mat noise(kSize, CV_8UC3);
        for (int k = 0; k < 20; ++k) {
          cv::randu(noise, 0, 255);
          video.add(k / kRate_hz, noise);
        }
        publish(folder, video);
      });
    }
    EXPECT_THAT(message, HasSubstr("cannot be written whole")) << codec.name;
    EXPECT_EQ(temp.count(), 0u) << codec.name;
  }
}

TEST(VideoFile, WithoutAPictureThereIsNone) {
  const TempFolder temp;
  ResultFolder folder(temp.path());
  VideoFile video(folder, "flight", kOwner, kRate_hz, kSize);
  publish(folder, video);
  EXPECT_EQ(temp.count(), 1u);
}

TEST(VideoFile, AVideoOfNoEarlierFlightIsNotReplaced) {
  const TempFolder temp;
  temp.write("flight.mp4", "mine");
  ResultFolder folder(temp.path());
  EXPECT_THAT(complaint([&] { VideoFile(folder, "flight", kOwner, kRate_hz, kSize); }),
              AllOf(HasSubstr("flight.mp4"), HasSubstr("not replaced")));
  temp.write(kOwner, "x");
  VideoFile video(folder, "flight", kOwner, kRate_hz, kSize);
  video.add(0.0, picture(0));
  publish(folder, video);
  EXPECT_EQ(frames_of(temp.path() / "flight.mp4").size(), 1u);
}

TEST(VideoFile, EarlierVideosOfAFlightGoAndOthersStay) {
  const TempFolder temp;
  temp.write("flight.mp4", "a");
  temp.write("flight.avi", "b");
  const auto publish_without = [&temp](const std::string& kept) {
    ResultFolder folder(temp.path());
    leave_out_videos(folder, "flight", kOwner, kept);
    folder.write("seal", "x");
    folder.publish();
  };
  publish_without("");
  EXPECT_TRUE(fs::exists(temp.path() / "flight.mp4") && fs::exists(temp.path() / "flight.avi"));
  temp.write("config.yaml", "x");
  publish_without("flight.mp4");
  EXPECT_TRUE(fs::exists(temp.path() / "flight.mp4"));
  EXPECT_FALSE(fs::exists(temp.path() / "flight.avi"));
}

}  // namespace
}  // namespace lineservo::apps
