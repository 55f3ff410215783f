#include "apps/config/camera/kalibr_camera.h"

#include "apps/config/camera/one_of.h"
#include "apps/config/camera/pinhole.h"
#include "apps/config/camera/yaml_entries.h"

namespace lineservo::apps {
namespace {

bool is_camera(const YAML::Node& node) {
  return node.IsMap() && (node["camera_model"] || node["intrinsics"]);
}

std::vector<std::string> names_of(const YamlReader& yaml) {
  std::vector<std::string> names;
  for (const auto& pair : yaml.root())
    if (is_camera(pair.second)) names.push_back(pair.first.Scalar());
  return names;
}

void take_intrinsics(const CameraEntries& entries, features::CameraParameters& camera) {
  const std::vector<double> values = entries.numbers({"intrinsics"});
  if (values.size() != 4 || !(values[0] > 0.0 && values[1] > 0.0))
    entries.fail(entries.at({"intrinsics"}), "must be fx, fy, cx, cy with fx and fy above 0");
  camera.fx_px = values[0];
  camera.fy_px = values[1];
  camera.cx_px = values[2];
  camera.cy_px = values[3];
}

}  // namespace

bool is_kalibr_chain(const YamlReader& yaml) {
  return !names_of(yaml).empty();
}

features::CameraParameters read_kalibr_camera(const YamlReader& yaml, const std::string& name) {
  const std::string chosen = one_of(names_of(yaml), name, yaml.file());
  const CameraEntries entries = entries_of(yaml, yaml.root()[chosen]);
  if (entries.word({"camera_model"}) != "pinhole") refuse_lens(entries, entries.at({"camera_model"}));
  const std::string lens = entries.word({"distortion_model"});
  if (lens != "radtan" && lens != "none") refuse_lens(entries, entries.at({"distortion_model"}));
  const std::vector<int> sides_px = entries.sides_px({"resolution"}, 2);
  features::CameraParameters camera{.width_px = sides_px[0], .height_px = sides_px[1]};
  take_intrinsics(entries, camera);
  if (lens == "radtan") take_lens(entries, {"distortion_coeffs"}, camera);
  return camera;
}

}  // namespace lineservo::apps
