#include "apps/config/camera/camera_file.h"

#include <stdexcept>

#include "apps/config/camera/kalibr_camera.h"
#include "apps/config/camera/opencv_camera.h"
#include "apps/config/camera/own_camera.h"
#include "apps/config/camera/ros_camera.h"
#include "apps/config/camera/visp_camera.h"
#include "apps/config/camera/xml_reader.h"
#include "apps/config/camera/yaml_entries.h"
#include "apps/config/input_error.h"
#include "apps/config/text_file.h"

namespace lineservo::apps {
namespace {

constexpr char kFormats[] =
    "is none of the camera files that can be read: ROS camera_info YAML, OpenCV FileStorage YAML or XML, "
    "Kalibr "
    "camchain YAML, ViSP XML, or YAML with width_px, height_px and focal_px";

/// A file, and which of its cameras.
struct CameraName {
  std::filesystem::path file;
  std::string camera;  ///< empty: the only one
};

CameraName named(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::string text = path.string();
  const std::size_t mark = text.rfind('#');
  if (mark == text.npos || std::filesystem::exists(path, ignored)) return {path, ""};
  return {text.substr(0, mark), text.substr(mark + 1)};
}

features::CameraParameters read_xml(const CameraName& name, const std::string& text) {
  const XmlReader xml(name.file, text);
  if (xml.root().name() == "opencv_storage") return read_opencv_camera(entries_of(xml, xml.root()));
  if (xml.root().child("camera")) return read_visp_camera(xml, name.camera);
  xml.fail(xml.root(), kFormats);
}

features::CameraParameters read_yaml(const CameraName& name, const std::string& text) {
  const YamlReader yaml(name.file, text);
  if (is_kalibr_chain(yaml)) return read_kalibr_camera(yaml, name.camera);
  if (is_own_camera(yaml)) return read_own_camera(yaml);
  const CameraEntries entries = entries_of(yaml, yaml.root());
  if (is_ros_camera(entries)) return read_ros_camera(entries);
  yaml.fail(yaml.root(), kFormats);
}

/// By content, whatever the file's name ends with.
features::CameraParameters read_any(const CameraName& name) {
  const std::string text = read_text_file(name.file);
  const std::size_t begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (begin == text.npos) throw InputError(name.file.string() + ": the file is empty");
  if (text[begin] == '<') return read_xml(name, text);
  if (is_opencv_yaml(text)) {
    const YamlReader yaml(name.file, without_directive(text));
    return read_opencv_camera(entries_of(yaml, yaml.root()));
  }
  return read_yaml(name, text);
}

}  // namespace

features::CameraParameters read_camera(const std::filesystem::path& file) {
  const features::CameraParameters camera = read_any(named(file));
  try {
    features::CameraModel{camera};
  } catch (const std::invalid_argument& fault) {
    throw InputError(file.string() + ": " + fault.what());
  }
  return camera;
}

}  // namespace lineservo::apps
