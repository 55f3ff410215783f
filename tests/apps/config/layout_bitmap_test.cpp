#include "apps/config/layout_bitmap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/layout_file.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;

class LayoutBitmapTest : public ::testing::Test {
 protected:
  vehicle::Layout read(const std::string& bitmap, const std::string& name = "l.yaml") {
    return read_layout(
        folder_.write(name, "name: test\n" + bitmap +
                                "\nnodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 3, y_m: 4}]\n"
                                "edges: [{from: p, to: q}]\nstart: {node: p}\n"));
  }
  std::string refusal(const std::string& bitmap) {
    return complaint([&] { read(bitmap); });
  }
  /// Red, blue; then green, black.
  void write_picture(const std::string& name = "f.ppm") {
    const char pixels[] = "\xff\0\0\0\0\xff\0\xff\0\0\0\0";
    folder_.write(name, "P6\n2 2\n255\n" + std::string(pixels, 12));
  }
  const testing::TempFolder folder_;
};

TEST_F(LayoutBitmapTest, ALayoutNeedsNone) {
  EXPECT_EQ(read("").bitmap, nullptr);
  EXPECT_FALSE(bitmap_file(folder_.path() / "l.yaml").has_value());
}

TEST_F(LayoutBitmapTest, IsReadFromBesideTheLayout) {
  write_picture();
  const auto bitmap = read("bitmap: {file: f.ppm, metres_per_pixel: 0.02, x_m: 1, y_m: -2}").bitmap;
  ASSERT_NE(bitmap, nullptr);
  EXPECT_EQ(bitmap->image().at<cv::Vec3b>(0, 1), cv::Vec3b(255, 0, 0));
  EXPECT_EQ(bitmap->metres_per_pixel(), 0.02);
  EXPECT_EQ(bitmap->origin_W(), Eigen::Vector2d(1, -2));
  EXPECT_EQ(read("bitmap: {file: f.ppm, metres_per_pixel: 0.02}").bitmap->origin_W(), Eigen::Vector2d(0, 0));
  EXPECT_EQ(bitmap_file(folder_.path() / "l.yaml"), folder_.path() / "f.ppm");
}

TEST_F(LayoutBitmapTest, AGreyPictureIsAFloorToo) {
  folder_.write("f.pgm", "P5\n2 1\n255\nab");
  EXPECT_EQ(read("bitmap: {file: f.pgm, metres_per_pixel: 0.02}").bitmap->image().at<cv::Vec3b>(0, 1),
            cv::Vec3b('b', 'b', 'b'));
}

TEST_F(LayoutBitmapTest, LayoutsShareItUntilItChanges) {
  write_picture();
  const std::string entry = "bitmap: {file: f.ppm, metres_per_pixel: 0.02}";
  const auto one = read(entry).bitmap;
  EXPECT_EQ(read(entry, "other.yaml").bitmap, one);
  EXPECT_NE(read("bitmap: {file: f.ppm, metres_per_pixel: 0.03}").bitmap, one);
  const auto later = std::filesystem::last_write_time(folder_.path() / "f.ppm") + std::chrono::seconds(5);
  std::filesystem::last_write_time(folder_.path() / "f.ppm", later);
  EXPECT_NE(read(entry).bitmap, one);
}

TEST_F(LayoutBitmapTest, RefusesWhatIsWrongByLineAndKey) {
  write_picture();
  const std::string at = (folder_.path() / "l.yaml").string() + ":2: ";
  for (const char* file : {"../f.ppm", "/tmp/f.ppm", "a/f.ppm", "f.yaml", "f", "summary.json"})
    EXPECT_THAT(refusal(std::string("bitmap: {metres_per_pixel: 0.01, file: ") + file + "}"),
                AllOf(HasSubstr(at), HasSubstr("'file' of bitmap"), HasSubstr(".png")))
        << file;
  for (const char* size : {"0", "-1", "1.5", "0.00001"})
    EXPECT_THAT(refusal(std::string("bitmap: {file: f.ppm, metres_per_pixel: ") + size + "}"),
                AllOf(HasSubstr(at), HasSubstr("'metres_per_pixel'"), HasSubstr("0.0001 to 1")))
        << size;
  EXPECT_THAT(refusal("bitmap: {file: f.ppm}"), AllOf(HasSubstr(at), HasSubstr("'metres_per_pixel'")));
  EXPECT_THAT(refusal("bitmap: {file: f.ppm, metres_per_pixel: 0.01, size: 2}"),
              HasSubstr("unknown key 'size'"));
  EXPECT_THAT(refusal("bitmap: {file: f.ppm, metres_per_pixel: 0.01, x_m: 1e5}"),
              HasSubstr("-10000 to 10000"));
  EXPECT_THAT(refusal("bitmap: f.ppm"), AllOf(HasSubstr(at), HasSubstr("must be a map")));
}

TEST_F(LayoutBitmapTest, RefusesAFileThatIsNoPicture) {
  EXPECT_THAT(refusal("bitmap: {file: none.png, metres_per_pixel: 0.01}"), HasSubstr("none.png: not a file"));
  folder_.write("junk.png", "no picture");
  EXPECT_THAT(refusal("bitmap: {file: junk.png, metres_per_pixel: 0.01}"),
              HasSubstr("junk.png: not an image"));
}

}  // namespace
}  // namespace lineservo::apps
