#include "apps/calibrate/camera_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lineservo::apps {

std::string ros_text(const features::CameraParameters& camera) {
  const auto& [width, height, fx, fy, cx, cy, lens] = camera;
  std::string text = fmt::format("image_width: {}\nimage_height: {}\ncamera_name: camera\n", width, height);
  const auto add = [&text](const char* key, int rows, int cols, const std::string& data) {
    text += fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: [{}]\n", key, rows, cols, data);
  };
  add("camera_matrix", 3, 3, fmt::format("{}, 0, {}, 0, {}, {}, 0, 0, 1", fx, cx, fy, cy));
  text += "distortion_model: plumb_bob\n";
  add("distortion_coefficients", 1, 5, fmt::format("{}", fmt::join(lens, ", ")));
  add("rectification_matrix", 3, 3, "1, 0, 0, 0, 1, 0, 0, 0, 1");
  add("projection_matrix", 3, 4, fmt::format("{}, 0, {}, 0, 0, {}, {}, 0, 0, 0, 1, 0", fx, cx, fy, cy));
  return text;
}

std::string visp_text(const VispCalibration& calibration) {
  const features::CameraParameters& camera = calibration.camera;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<root>\n  <camera>\n    <name>camera</name>\n"
      "    <image_width>{}</image_width>\n    <image_height>{}</image_height>\n"
      "    <model>\n      <type>perspectiveProjWithDistortion</type>\n",
      camera.width_px, camera.height_px);
  const auto add = [&text](const char* key, double value) {
    text += fmt::format("      <{0}>{1}</{0}>\n", key, value);
  };
  add("px", camera.fx_px);
  add("py", camera.fy_px);
  add("u0", camera.cx_px);
  add("v0", camera.cy_px);
  add("kud", camera.distortion[0]);
  add("kdu", calibration.kdu);
  return text + "    </model>\n  </camera>\n</root>\n";
}

}  // namespace lineservo::apps
