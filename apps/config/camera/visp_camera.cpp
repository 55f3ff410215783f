#include "apps/config/camera/visp_camera.h"

#include "apps/config/camera/one_of.h"
#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

constexpr char kWithLens[] = "perspectiveProjWithDistortion";
constexpr char kWithoutLens[] = "perspectiveProjWithoutDistortion";

std::string text_of(const XmlElement& element, const std::string& key) {
  const auto child = element.child(key);
  const auto words = child ? child->words() : std::vector<std::string>{};
  return words.empty() ? "" : words.front();
}

std::vector<XmlElement> cameras(const XmlReader& xml) {
  std::vector<XmlElement> list;
  for (const XmlElement& element : xml.root().children())
    if (element.name() == "camera") list.push_back(element);
  return list;
}

XmlElement chosen_camera(const XmlReader& xml, const std::string& name) {
  std::vector<std::string> names;
  for (const XmlElement& camera : cameras(xml)) names.push_back(text_of(camera, "name"));
  const std::string chosen = one_of(names, name, xml.file());
  std::optional<XmlElement> found;
  for (const XmlElement& camera : cameras(xml)) {
    if (text_of(camera, "name") != chosen) continue;
    if (found) xml.fail(camera, "a second camera named '" + chosen + "': only one may stand in a file");
    found = camera;
  }
  return *found;
}

std::optional<XmlElement> model(const XmlElement& camera, const std::string& type) {
  for (const XmlElement& element : camera.children())
    if (element.name() == "model" && text_of(element, "type") == type) return element;
  return std::nullopt;
}

double positive(const CameraEntries& entries, const std::string& key) {
  const double value = entries.number({key});
  if (!(value > 0.0)) entries.fail(entries.at({key}), "must be above 0");
  return value;
}

/// The size stands beside the models, which may be several.
features::CameraParameters read_size(const XmlReader& xml, const XmlElement& camera) {
  CameraEntries entries(xml.file(), camera.line());
  for (const char* const key : {"image_width", "image_height"})
    if (const auto side = camera.child(key)) entries.add({key, side->words(), side->line()});
  return {.width_px = entries.side_px({"image_width"}), .height_px = entries.side_px({"image_height"})};
}

}  // namespace

features::CameraParameters read_visp_camera(const XmlReader& xml, const std::string& name) {
  const XmlElement element = chosen_camera(xml, name);
  const auto lens = model(element, kWithLens), plain = model(element, kWithoutLens);
  if (!lens && !plain)
    xml.fail(element, std::string("key 'model': needs one of the type ") + kWithLens + " or " + kWithoutLens);
  const CameraEntries entries = entries_of(xml, lens ? *lens : *plain);
  features::CameraParameters camera = read_size(xml, element);
  camera.fx_px = positive(entries, "px");
  camera.fy_px = positive(entries, "py");
  camera.cx_px = entries.number({"u0"});
  camera.cy_px = entries.number({"v0"});
  if (lens) camera.distortion[0] = entries.number({"kud"});
  return camera;
}

}  // namespace lineservo::apps
