#include "apps/config/camera_file.h"

#include <cmath>

#include "apps/config/input_error.h"
#include "apps/config/yaml_reader.h"

namespace lineservo::apps {
namespace {

int whole_number(const YamlReader& yaml, const std::string& key) {
  const double value = yaml.number(yaml.root(), key);
  if (value != std::floor(value) || std::abs(value) > 1e6)
    yaml.fail(yaml.root()[key], "key '" + key + "' must be a whole number of pixels");
  return static_cast<int>(value);
}

void read_focal(const YamlReader& yaml, features::CameraParameters& camera) {
  const YAML::Node& root = yaml.root();
  const bool both = root["fx_px"] && root["fy_px"], one = root["fx_px"] || root["fy_px"];
  if (static_cast<bool>(root["focal_px"]) == one || one != both)
    yaml.fail(root, "needs either focal_px, or both fx_px and fy_px");
  camera.fx_px = yaml.number(root, both ? "fx_px" : "focal_px");
  camera.fy_px = yaml.number(root, both ? "fy_px" : "focal_px");
}

}  // namespace

features::CameraParameters read_camera(const std::filesystem::path& file) {
  const YamlReader yaml(file);
  const YAML::Node& root = yaml.root();
  yaml.allow(
      root,
      {"width_px", "height_px", "focal_px", "fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2", "k3"},
      "a camera");
  features::CameraParameters camera;
  camera.width_px = whole_number(yaml, "width_px");
  camera.height_px = whole_number(yaml, "height_px");
  read_focal(yaml, camera);
  camera.cx_px = yaml.number(root, "cx_px", 0.5 * (camera.width_px - 1));
  camera.cy_px = yaml.number(root, "cy_px", 0.5 * (camera.height_px - 1));
  const char* const lens[] = {"k1", "k2", "p1", "p2", "k3"};
  for (std::size_t k = 0; k < camera.distortion.size(); ++k)
    camera.distortion[k] = yaml.number(root, lens[k], 0.0);
  try {
    features::CameraModel{camera};
  } catch (const std::invalid_argument& fault) {
    throw InputError(file.string() + ": " + fault.what());
  }
  return camera;
}

}  // namespace lineservo::apps
