#pragma once

#include "apps/config/yaml_reader.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Whether the file has a key of ours.
bool is_own_camera(const YamlReader& yaml);

/// Our own keys, all in pixels: width_px, height_px; focal_px, or fx_px and fy_px; cx_px and cy_px (the
/// middle of the image by default); k1, k2, p1, p2, k3 (0 by default). Throws InputError for anything else.
features::CameraParameters read_own_camera(const YamlReader& yaml);

}  // namespace lineservo::apps
