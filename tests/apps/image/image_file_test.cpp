#include "apps/image/image_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

namespace fs = std::filesystem;

fs::path written(const std::string& name, const std::string& bytes) {
  const fs::path file = fs::path(testing::TempDir()) / ("image_file_" + name);
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

TEST(ImageFile, ReadsColourAsBgr) {
  const std::string pixels{'\xff', '\x00', '\x00', '\x00', '\x00', '\x80'};  // red, dark blue
  const cv::Mat image = read_image(written("colour.ppm", "P6\n2 1\n255\n" + pixels));
  ASSERT_EQ(image.type(), CV_8UC3);
  ASSERT_EQ(image.size(), cv::Size(2, 1));
  EXPECT_EQ(image.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255));
  EXPECT_EQ(image.at<cv::Vec3b>(0, 1), cv::Vec3b(128, 0, 0));
}

TEST(ImageFile, KeepsGreyGrey) {
  const cv::Mat image = read_image(written("grey.pgm", "P5\n3 1\n255\nabc"));
  ASSERT_EQ(image.type(), CV_8UC1);
  EXPECT_EQ(image.at<std::uint8_t>(0, 2), 'c');
}

TEST(ImageFile, RefusesWhatIsNoImage) {
  EXPECT_THROW(read_image(fs::path(testing::TempDir()) / "image_file_that_is_not"), InputError);
  EXPECT_THROW(read_image(testing::TempDir()), InputError);
  EXPECT_THROW(read_image(written("empty.png", "")), InputError);
  EXPECT_THROW(read_image(written("text.png", "not a picture")), InputError);
}

}  // namespace
}  // namespace lineservo::apps
