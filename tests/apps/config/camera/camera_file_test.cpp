#include "apps/config/camera/camera_file.h"

#include "tests/apps/config/camera/camera_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using CameraFile = testing::CameraFileTest;

TEST_F(CameraFile, SaysWhatItCanRead) {
  EXPECT_THAT(refusal("focus: 3\n"), AllOf(HasSubstr("camera:1: is none of the camera files"),
                                           HasSubstr("ROS camera_info"), HasSubstr("ViSP XML")));
  EXPECT_THAT(refusal("<root><lens/></root>"), HasSubstr("camera:1: is none of the camera files"));
}

TEST_F(CameraFile, RefusesWhatIsNoCameraFile) {
  EXPECT_THAT(refusal(""), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal(" \n"), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal("<"), HasSubstr("camera:1: not XML"));
  EXPECT_THAT(refusal("%YAML:1.0"), HasSubstr("must be a map"));
  EXPECT_THAT(refusal("- 1\n"), HasSubstr("must be a map"));
  EXPECT_THAT(refusal("\xFF"), HasSubstr("not UTF-8"));
  EXPECT_THAT(testing::complaint([this] { read_camera(temp_.path() / "none"); }),
              HasSubstr("cannot be read"));
  EXPECT_THAT(testing::complaint([this] { read_camera(temp_.path()); }), HasSubstr("is a folder"));
}

TEST_F(CameraFile, RefusesALensThatFoldsBeforeTheCorners) {
  EXPECT_THAT(refusal("width_px: 640\nheight_px: 480\nfocal_px: 200\nk1: -0.4\n"),
              HasSubstr("camera: camera: the distortion cannot be undone at the image's corners"));
}

TEST_F(CameraFile, AFileWhoseNameHasTheMarkIsThatFile) {
  const auto file = temp_.write("a#b", "width_px: 640\nheight_px: 480\nfocal_px: 321\n");
  EXPECT_EQ(read_camera(file).fx_px, 321.0);
}

}  // namespace
}  // namespace lineservo::apps
