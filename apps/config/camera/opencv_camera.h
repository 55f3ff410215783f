#pragma once

#include <string>
#include <string_view>

#include "apps/config/camera/camera_entries.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Whether the text is OpenCV's dialect of YAML, which begins with "%YAML:1.0" (and so is not YAML), or its
/// JSON, which tells itself by the type of its matrices.
bool is_opencv_yaml(std::string_view text);
/// The same text without that line's content, as YAML: JSON is YAML too. The other lines stay where they
/// were.
std::string without_directive(std::string text);

/// What OpenCV's calibration programs put into a FileStorage: image_width, image_height, camera_matrix,
/// distortion_coefficients, in their spellings of several releases. A fisheye model is refused. Throws
/// InputError.
features::CameraParameters read_opencv_camera(const CameraEntries& entries);

}  // namespace lineservo::apps
