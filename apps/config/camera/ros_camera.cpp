#include "apps/config/camera/ros_camera.h"

#include "apps/config/camera/pinhole.h"

namespace lineservo::apps {
namespace {

const Spellings kMatrix = {"camera_matrix", "K", "k"};
const Spellings kModel = {"distortion_model"};

}  // namespace

bool is_ros_camera(const CameraEntries& entries) {
  return entries.has(kMatrix) || entries.has(kModel);
}

features::CameraParameters read_ros_camera(const CameraEntries& entries) {
  features::CameraParameters camera;
  camera.width_px = entries.side_px({"image_width", "width"});
  camera.height_px = entries.side_px({"image_height", "height"});
  take_matrix(entries, kMatrix, camera);
  const std::string model = entries.word(kModel);
  if (model != "plumb_bob" && model != "rational_polynomial") refuse_lens(entries, entries.at(kModel));
  take_lens(entries, {"distortion_coefficients", "D", "d"}, camera);
  return camera;
}

}  // namespace lineservo::apps
