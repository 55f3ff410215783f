#include "apps/config/camera/own_camera.h"

#include <algorithm>
#include <cmath>

namespace lineservo::apps {
namespace {

const std::vector<std::string> kKeys = {"width_px", "height_px", "focal_px", "fx_px", "fy_px", "cx_px",
                                        "cy_px",    "k1",        "k2",       "p1",    "p2",    "k3"};

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

bool is_own_camera(const YamlReader& yaml) {
  return std::any_of(kKeys.begin(), kKeys.end(),
                     [&yaml](const std::string& key) { return static_cast<bool>(yaml.root()[key]); });
}

features::CameraParameters read_own_camera(const YamlReader& yaml) {
  const YAML::Node& root = yaml.root();
  yaml.allow(root, kKeys, "a camera");
  features::CameraParameters camera;
  camera.width_px = whole_number(yaml, "width_px");
  camera.height_px = whole_number(yaml, "height_px");
  read_focal(yaml, camera);
  camera.cx_px = yaml.number(root, "cx_px", 0.5 * (camera.width_px - 1));
  camera.cy_px = yaml.number(root, "cy_px", 0.5 * (camera.height_px - 1));
  const char* const lens[] = {"k1", "k2", "p1", "p2", "k3"};
  for (std::size_t k = 0; k < camera.distortion.size(); ++k)
    camera.distortion[k] = yaml.number(root, lens[k], 0.0);
  return camera;
}

}  // namespace lineservo::apps
