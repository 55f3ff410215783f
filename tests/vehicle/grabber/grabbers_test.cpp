#include "vehicle/grabber/grabbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "tests/vehicle/grabber/source_files.h"
#include "vehicle/grabber/device_formats.h"

namespace lineservo::vehicle {
namespace {

using ::testing::HasSubstr;

class Grabbers : public ::testing::Test {
 protected:
  /// A frame that tells its number by its colour.
  static cv::Mat image(int k, int width_px = 64) {
    return cv::Mat(48, width_px, CV_8UC3, cv::Scalar(10 + 20 * k, 20 + 20 * k, 30 + 20 * k));
  }
  void write_images(const std::vector<std::string>& names) const {
    for (std::size_t k = 0; k < names.size(); ++k)
      cv::imwrite(folder_.path(names[k]), image(static_cast<int>(k)));
  }
  void write_video(const std::string& name, int frames) const {
    cv::VideoWriter writer(folder_.path(name), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 12.5, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    for (int k = 0; k < frames; ++k) writer.write(image(k));
  }
  std::string opening(const std::string& name) const {
    return test::complaint([&] { open_source(name); });
  }
  /// The numbers that the frames tell; a complaint ends the list, and goes to `complaint_`.
  std::vector<int> numbers(FrameSource& source) {
    std::vector<int> list;
    complaint_ = test::complaint([&] {
      while (const auto frame = source.next()) {
        EXPECT_EQ(frame->index, static_cast<std::int64_t>(list.size()));
        list.push_back((frame->bgr.at<cv::Vec3b>(24, 32)[1] - 20 + 10) / 20);
      }
    });
    return list;
  }

  const test::SourceFolder folder_;
  std::string complaint_;
};

TEST_F(Grabbers, AFolderGivesItsImagesInOrderBitForBit) {
  write_images({"a.png", "b.png", "c.png"});
  folder_.write("notes.txt", "no image");
  GrabberOptions options;
  options.rate_hz = 10.0;
  const auto source = open_source(folder_.path(), options);
  EXPECT_EQ(source->format().width_px, 64);
  EXPECT_EQ(source->format().height_px, 48);
  EXPECT_EQ(cv::norm(source->next()->bgr, image(0), cv::NORM_INF), 0.0);
  const auto second = source->next();
  EXPECT_EQ(cv::norm(second->bgr, image(1), cv::NORM_INF), 0.0);
  EXPECT_EQ(second->stamp, from_seconds(0.1));
  EXPECT_TRUE(source->next());
  EXPECT_FALSE(source->next());
}

TEST_F(Grabbers, AFolderWithoutImagesOrWithABrokenOneIsTold) {
  EXPECT_THAT(opening(folder_.path()), HasSubstr("no image (png"));
  write_images({"a.png"});
  folder_.write("b.png", "no image");
  const auto source = open_source(folder_.path());
  EXPECT_EQ(numbers(*source), (std::vector<int>{0}));
  EXPECT_THAT(complaint_, HasSubstr("b.png: is not an image"));
}

TEST_F(Grabbers, AnImageOfAnotherSizeEndsTheFolder) {
  write_images({"a.png", "b.png"});
  cv::imwrite(folder_.path("c.png"), image(2, 32));
  const auto source = open_source(folder_.path());
  EXPECT_EQ(numbers(*source), (std::vector<int>{0, 1}));
  EXPECT_THAT(complaint_, HasSubstr("frame 2 is 32×48 px, the source 64×48"));
}

TEST_F(Grabbers, ASequenceBeginsAtItsFirstNumberBitForBit) {
  write_images({"f0007.png", "f0008.png", "f0009.png"});
  const auto source = open_source(folder_.path("f%04d.png"));
  EXPECT_EQ(source->format().width_px, 64);
  EXPECT_EQ(cv::norm(source->next()->bgr, image(0), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(source->next()->bgr, image(1), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(source->next()->bgr, image(2), cv::NORM_INF), 0.0);
  EXPECT_FALSE(source->next());
}

TEST_F(Grabbers, AGapInASequenceIsTold) {
  write_images({"f1.png", "f2.png", "f4.png"});
  const auto source = open_source(folder_.path("f%d.png"));
  EXPECT_EQ(numbers(*source), (std::vector<int>{0, 1}));
  EXPECT_THAT(complaint_, HasSubstr("number 3 is missing"));
  EXPECT_THAT(opening(folder_.path("g%d.png")), HasSubstr("there is no such image"));
  EXPECT_THAT(opening(folder_.path("f%s.png")), HasSubstr("must have one %d"));
  folder_.write("h1.png", "no image");
  EXPECT_THAT(opening(folder_.path("h%d.png")), HasSubstr("number 1 is not an image"));
}

// Each frame once: the first is not skipped, the last is not repeated.
TEST_F(Grabbers, AVideoGivesEachFrameOnce) {
  write_video("v.avi", 6);
  const auto source = open_source(folder_.path("v.avi"));
  EXPECT_EQ(source->format().width_px, 64);
  EXPECT_EQ(source->format().height_px, 48);
  EXPECT_NEAR(source->format().rate_hz, 12.5, 1e-9);
  EXPECT_EQ(numbers(*source), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(complaint_, "no error");
}

// An equal frame is not taken for the repeated last one.
TEST_F(Grabbers, AVideoOfEqualFramesIsWhole) {
  cv::VideoWriter writer(folder_.path("same.avi"), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0,
                         {64, 48});
  for (int k = 0; k < 4; ++k) writer.write(image(1));
  writer.release();
  EXPECT_EQ(numbers(*open_source(folder_.path("same.avi"))), (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(complaint_, "no error");
}

TEST_F(Grabbers, AVideoThatIsCutShortEndsWithAComplaint) {
  const std::string file = folder_.path("v.avi");
  cv::VideoWriter writer(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0, {64, 48});
  cv::RNG random(1);
  for (int k = 0; k < 40; ++k) {
    cv::Mat noise(48, 64, CV_8UC3);
    random.fill(noise, cv::RNG::UNIFORM, 0, 256);
    writer.write(noise);
  }
  writer.release();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 6 / 10);
  const auto source = open_source(file);
  const std::vector<int> seen = numbers(*source);
  EXPECT_GT(seen.size(), 10u);
  EXPECT_LT(seen.size(), 40u);
  EXPECT_THAT(complaint_,
              HasSubstr("v.avi: stops after " + std::to_string(seen.size()) + " frames: the next one"));
}

TEST_F(Grabbers, WhatIsNoVideoIsRefused) {
  folder_.write("noise.mp4", "no video at all");
  write_video("one.avi", 1);
  EXPECT_THAT(opening(folder_.path("one.avi")), HasSubstr("one.avi: is not a video of at least two frames"));
  folder_.write("noending", "no video at all");
  EXPECT_THAT(opening(folder_.path("noise.mp4")), HasSubstr("noise.mp4: is not a video"));
  EXPECT_THAT(opening(folder_.path("noending")), HasSubstr("must end with its format"));
  EXPECT_THAT(opening(folder_.path("none.mp4")), HasSubstr("there is no such file"));
}

TEST_F(Grabbers, ADeviceThatIsNotThereOrDoesNotCapture) {
  EXPECT_THAT(opening("/dev/video987"), HasSubstr("/dev/video987: cannot be opened: No such file"));
  EXPECT_THAT(opening("987"), HasSubstr("/dev/video987: cannot be opened"));
  EXPECT_THAT(opening("/dev/null"), HasSubstr("/dev/null: is not a V4L2 device"));
}

TEST_F(Grabbers, AUrlOrPipelineThatDoesNotOpen) {
  EXPECT_THAT(opening("rtsp://127.0.0.1:1/live"), HasSubstr("rtsp://127.0.0.1:1/live: cannot be opened"));
  EXPECT_THAT(opening("nosuchsource ! appsink"), HasSubstr("nosuchsource ! appsink: cannot be opened"));
}

TEST(DeviceReaders, RawFormatsGoToVispAtItsRatesAllElseToOpenCv) {
  EXPECT_EQ(device_reader({V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}, 25.0), DeviceReader::visp_yuyv);
  EXPECT_EQ(device_reader({V4L2_PIX_FMT_MJPEG, V4L2_PIX_FMT_YUYV}, 30.0), DeviceReader::capture);
  EXPECT_EQ(device_reader({V4L2_PIX_FMT_RGB24}, 50.0), DeviceReader::visp_rgb);
  EXPECT_EQ(device_reader({V4L2_PIX_FMT_GREY}, 50.0), DeviceReader::visp_grey);
  EXPECT_EQ(device_reader({V4L2_PIX_FMT_MJPEG}, 25.0), DeviceReader::capture);
}

TEST(DeviceReaders, MjpegIsAskedForWhereItIsOffered) {
  EXPECT_EQ(capture_format({V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_MJPEG}), std::uint32_t{V4L2_PIX_FMT_MJPEG});
  EXPECT_EQ(capture_format({V4L2_PIX_FMT_YUYV}), 0u);
}

}  // namespace
}  // namespace lineservo::vehicle
