#include "apps/image/image_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <string_view>

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

/// A grey JPEG picture of 16×16 px.
std::string jpeg() {
  const std::string_view digits =
      "ffd8ffe000104a46494600010100000100010000ffdb004300100b0c0e0c0a100e0d0e1211101318281a181616"
      "183123251d283a333d3c3933383740485c4e404457453738506d51575f626768673e4d71797064785c656763ff"
      "c0000b080010001001011100ffc4001500010100000000000000000000000000000002ffc4001a100000070000"
      "0000000000000000000000000103053582b2ffda0008010100003f009689246d93077925ab920689246d930779"
      "25ab921fffd9";
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2)
    bytes += static_cast<char>(std::stoi(std::string(digits.substr(k, 2)), nullptr, 16));
  return bytes;
}

TEST(ImageFile, RefusesAJpegFileThatIsCutShort) {
  const std::string whole = jpeg();
  EXPECT_EQ(read_image(written("whole.jpg", whole)).size(), cv::Size(16, 16));
  EXPECT_EQ(read_image(written("more.jpg", whole + "\xFF\xDA and more")).size(), cv::Size(16, 16));
  EXPECT_THROW(read_image(written("cut.jpg", whole.substr(0, whole.size() - 12))), InputError);
  EXPECT_THROW(read_image(written("end.jpg", whole.substr(0, whole.size() - 2))), InputError);
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

TEST(ImageFile, PngIsWithoutLoss) {
  cv::Mat image(31, 47, CV_8UC3);
  cv::RNG random(3);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  const cv::Mat read = read_image(written("noise.png", png_bytes(image)));
  EXPECT_EQ(read.type(), CV_8UC3);
  EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0.0);
}

TEST(ImageFile, JpegIsSmallerTheLowerTheQuality) {
  cv::Mat image(31, 47, CV_8UC3);
  cv::RNG random(3);
  random.fill(image, cv::RNG::UNIFORM, 100, 140);
  const std::string good = jpeg_bytes(image, 95), poor = jpeg_bytes(image, 40);
  EXPECT_LT(poor.size(), good.size());
  const cv::Mat read = read_image(written("good.jpg", good));
  EXPECT_EQ(read.type(), CV_8UC3);
  EXPECT_LT(cv::norm(read, image, cv::NORM_L1) / static_cast<double>(image.total() * 3), 10.0);
}

}  // namespace
}  // namespace lineservo::apps
