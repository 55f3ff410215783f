#include "apps/config/camera/ros_camera.h"

#include "tests/apps/config/camera/camera_files.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using testing::with;
using RosCamera = testing::CameraFileTest;

/// As camera_calibration_parsers writes it.
const std::string kFile =
    "image_width: 640\n"
    "image_height: 480\n"
    "camera_name: down\n"
    "camera_matrix:\n"
    "  rows: 3\n"
    "  cols: 3\n"
    "  data: [401.5, 0, 320.25, 0, 402.5, 240.75, 0, 0, 1]\n"
    "distortion_model: plumb_bob\n"
    "distortion_coefficients:\n"
    "  rows: 1\n"
    "  cols: 5\n"
    "  data: [-0.21, 0.05, 0.001, -0.002, 0.003]\n"
    "rectification_matrix:\n"
    "  rows: 3\n"
    "  cols: 3\n"
    "  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
    "projection_matrix:\n"
    "  rows: 3\n"
    "  cols: 4\n"
    "  data: [390, 0, 321, 0, 0, 391, 241, 0, 0, 0, 1, 0]\n";

TEST_F(RosCamera, TakesMatrixAndLens) {
  const auto camera = read(kFile);
  EXPECT_EQ(camera.width_px, 640);
  EXPECT_EQ(camera.height_px, 480);
  EXPECT_EQ(camera.fx_px, 401.5);
  EXPECT_EQ(camera.fy_px, 402.5);
  EXPECT_EQ(camera.cx_px, 320.25);
  EXPECT_EQ(camera.cy_px, 240.75);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{-0.21, 0.05, 0.001, -0.002, 0.003}));
}

TEST_F(RosCamera, TakesTheMessageAsATopicShowsIt) {
  const auto camera = read(
      "header:\n  seq: 3\n  frame_id: \"down\"\nheight: 480\nwidth: 640\ndistortion_model: \"plumb_bob\"\n"
      "D: [-0.2, 0.1, 0.0, 0.0, 0.0]\nK: [400.0, 0.0, 319.5, 0.0, 400.0, 239.5, 0.0, 0.0, 1.0]\n"
      "R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\nbinning_x: 0\n");
  EXPECT_EQ(camera.fx_px, 400.0);
  EXPECT_EQ(camera.distortion[0], -0.2);
}

TEST_F(RosCamera, TakesARationalModelWhoseMoreTermsAreZero) {
  const std::string file = with(kFile, "plumb_bob", "rational_polynomial");
  const std::string eight = with(with(file, "cols: 5", "cols: 8"), "0.003]", "0.003, 0, 0.0, 0]");
  EXPECT_EQ(read(eight).distortion[4], 0.003);
  EXPECT_THAT(refusal(with(eight, "0, 0.0, 0]", "0, 0.1, 0]")),
              HasSubstr("camera:9: key 'distortion_coefficients': number 7 is 0.1, not 0"));
}

TEST_F(RosCamera, RefusesLensesThatCannotBeHeld) {
  EXPECT_THAT(refusal(with(kFile, "plumb_bob", "equidistant")),
              HasSubstr("camera:8: key 'distortion_model': the lens model 'equidistant' is refused"));
  EXPECT_THAT(refusal(with(kFile, "data: [401.5, 0,", "data: [401.5, 2,")),
              HasSubstr("camera:4: key 'camera_matrix': must be fx 0 cx"));
}

TEST_F(RosCamera, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(refusal(with(kFile, "image_height: 480\n", "")), HasSubstr("key 'image_height' is missing"));
  EXPECT_THAT(refusal(with(kFile, "image_width: 640", "image_width: 640.5")),
              HasSubstr("camera:1: key 'image_width': must be whole numbers of 16 to 16384"));
  EXPECT_THAT(refusal(with(kFile, "320.25", ".nan")),
              HasSubstr("camera:4: key 'camera_matrix': '.nan' must be a finite number"));
  EXPECT_THAT(refusal(with(kFile, "240.75, ", "")),
              HasSubstr("camera:7: key 'data' must be as many numbers as 'rows' times 'cols'"));
  EXPECT_THAT(refusal(with(kFile, "distortion_model: plumb_bob\n", "")),
              HasSubstr("key 'distortion_model' is missing"));
  EXPECT_THAT(refusal(with(kFile, "401.5", "0")), HasSubstr("fx and fy above 0"));
  EXPECT_THAT(refusal(with(with(kFile, "cols: 5", "cols: 3"), ", -0.002, 0.003", "")),
              HasSubstr("camera:9: key 'distortion_coefficients': has 3 numbers, must have 4, 5"));
}

}  // namespace
}  // namespace lineservo::apps
