#pragma once

#include <filesystem>

#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Reads the parameters of a camera, all in pixels: width_px, height_px; focal_px, or fx_px and fy_px; cx_px
/// and cy_px (the middle of the image by default); k1, k2, p1, p2, k3 (0 by default). Throws InputError, with
/// file, line and key, for anything else.
features::CameraParameters read_camera(const std::filesystem::path& file);

}  // namespace lineservo::apps
