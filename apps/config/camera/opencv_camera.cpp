#include "apps/config/camera/opencv_camera.h"

#include "apps/config/camera/pinhole.h"

namespace lineservo::apps {
namespace {

constexpr std::string_view kDirective = "%YAML:";

}  // namespace

bool is_opencv_yaml(std::string_view text) {
  return text.starts_with(kDirective) || (text.starts_with('{') && text.find("opencv-matrix") != text.npos);
}

std::string without_directive(std::string text) {
  return text.starts_with(kDirective) ? text.erase(0, text.find('\n')) : text;
}

features::CameraParameters read_opencv_camera(const CameraEntries& entries) {
  features::CameraParameters camera;
  camera.width_px = entries.side_px({"image_width", "image_Width", "imageWidth", "width"});
  camera.height_px = entries.side_px({"image_height", "image_Height", "imageHeight", "height"});
  take_matrix(entries, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K"}, camera);
  if (entries.has({"fisheye_model"}) && entries.number({"fisheye_model"}) != 0.0)
    entries.fail(entries.at({"fisheye_model"}),
                 "a fisheye lens is refused: only k1, k2, p1, p2, k3 can be used");
  take_lens(entries, {"distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "D"}, camera);
  return camera;
}

}  // namespace lineservo::apps
