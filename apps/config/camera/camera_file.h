#pragma once

#include <filesystem>

#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Reads a camera file, whose format is told by its content: ROS camera_info (YAML), OpenCV FileStorage
/// (YAML, XML or JSON), a Kalibr camchain, ViSP's XML, or our own YAML (read_own_camera()). Of a file that
/// holds several cameras, FILE#NAME is one. Throws InputError, with file, line and key, for anything else,
/// and for a lens that features::CameraParameters cannot hold.
features::CameraParameters read_camera(const std::filesystem::path& file);

}  // namespace lineservo::apps
