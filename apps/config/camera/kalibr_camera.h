#pragma once

#include <string>

#include "apps/config/yaml_reader.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Whether the file is a chain of cameras: maps with a camera_model.
bool is_kalibr_chain(const YamlReader& yaml);

/// The camera of that name in Kalibr's camchain; an empty name is the only one. The model pinhole with the
/// lens radtan or none; others are refused. Throws InputError.
features::CameraParameters read_kalibr_camera(const YamlReader& yaml, const std::string& name);

}  // namespace lineservo::apps
