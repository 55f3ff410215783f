#include "apps/config/camera/opencv_camera.h"

#include <opencv2/core/persistence.hpp>

#include "tests/apps/config/camera/camera_files.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using testing::with;
using OpenCvCamera = testing::CameraFileTest;

const cv::Matx33d kMatrix(401.5, 0, 320.25, 0, 402.5, 240.75, 0, 0, 1);

/// As OpenCV itself writes it; `kind` is .yml or .xml.
std::string stored(const std::string& kind, const std::vector<double>& lens, int fisheye = 0) {
  cv::FileStorage file(kind, cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "calibration_time"
       << "Mon 03 Jun 2024 10:11:12"
       << "nr_of_frames" << 12 << "image_width" << 640 << "image_height" << 480;
  file << "flags" << 0 << "fisheye_model" << fisheye << "camera_matrix" << cv::Mat(kMatrix);
  file << "distortion_coefficients" << cv::Mat(lens) << "avg_reprojection_error" << 0.21;
  file << "grid_points" << std::vector<cv::Point3f>{{0, 0, 0}, {1, 0, 0}};
  return file.releaseAndGetString();
}

TEST_F(OpenCvCamera, TakesWhatOpenCvWrites) {
  for (const char* const kind : {".yml", ".xml", ".json"}) {
    const auto camera = read(stored(kind, {-0.21, 0.05, 0.001, -0.002, 0.003}));
    EXPECT_EQ(camera.width_px, 640) << kind;
    EXPECT_EQ(camera.height_px, 480) << kind;
    EXPECT_EQ(camera.fx_px, 401.5) << kind;
    EXPECT_EQ(camera.fy_px, 402.5) << kind;
    EXPECT_EQ(camera.cx_px, 320.25) << kind;
    EXPECT_EQ(camera.cy_px, 240.75) << kind;
    EXPECT_EQ(camera.distortion, (std::array<double, 5>{-0.21, 0.05, 0.001, -0.002, 0.003})) << kind;
  }
}

TEST_F(OpenCvCamera, TakesTheSpellingOfOlderReleases) {
  const auto camera = read(
      "%YAML:1.0\nimage_Width: 320\nimage_Height: 240\nCamera_Matrix: !!opencv-matrix\n   rows: 3\n   cols: "
      "3\n"
      "   dt: d\n   data: [ 2.5e+02, 0., 1.5950e+02, 0., 2.5e+02,\n       1.1950e+02, 0., 0., 1. ]\n"
      "Distortion_Coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n"
      "   data: [ -1.e-01, 0., 0., 0., 0. ]\n");
  EXPECT_EQ(camera.fx_px, 250.0);
  EXPECT_EQ(camera.distortion[0], -0.1);
}

TEST_F(OpenCvCamera, RefusesLensesThatCannotBeHeld) {
  for (const char* const kind : {".yml", ".xml"}) {
    EXPECT_EQ(read(stored(kind, {-0.05, 0, 0, 0, 0, 0, 0, 0})).distortion[0], -0.05) << kind;
    EXPECT_THAT(refusal(stored(kind, {-0.05, 0, 0, 0, 0, 0.5, 0, 0})),
                HasSubstr("key 'distortion_coefficients': number 6 is 0.5, not 0"))
        << kind;
    EXPECT_THAT(refusal(stored(kind, {-0.05, 0, 0, 0}, 1)), HasSubstr("key 'fisheye_model'")) << kind;
  }
}

TEST_F(OpenCvCamera, SaysWhatIsWrongAndWhere) {
  const std::string yaml = stored(".yml", {-0.05, 0, 0, 0}), xml = stored(".xml", {-0.05, 0, 0, 0});
  EXPECT_THAT(refusal(with(yaml, "image_width: 640", "image_width: wide")),
              HasSubstr("camera:5: key 'image_width': 'wide' must be a finite number"));
  EXPECT_THAT(refusal(with(xml, "<image_width>640", "<image_width>wide")),
              HasSubstr("camera:5: key 'image_width': 'wide' must be a finite number"));
  EXPECT_THAT(refusal(with(xml, "<image_width>640</image_width>", "")),
              HasSubstr("'image_width' is missing"));
  EXPECT_THAT(refusal(with(xml, "<rows>3", "<rows>2")), HasSubstr("'rows' times 'cols'"));
  EXPECT_THAT(refusal(with(xml, "</opencv_storage>", "")), HasSubstr("not XML"));
  EXPECT_THAT(refusal(with(yaml, "[ ", "[ [ ")), HasSubstr("not YAML"));
}

}  // namespace
}  // namespace lineservo::apps
