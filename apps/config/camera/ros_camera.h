#pragma once

#include "apps/config/camera/camera_entries.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// Whether the entries are those of ROS: a camera matrix, or a distortion model.
bool is_ros_camera(const CameraEntries& entries);

/// camera_info as camera_calibration_parsers writes it, or the message as a topic shows it. The lens models
/// plumb_bob, and rational_polynomial with k4 to k6 of 0. Rectification and projection are of no account:
/// frames are taken as they come from the camera. Throws InputError.
features::CameraParameters read_ros_camera(const CameraEntries& entries);

}  // namespace lineservo::apps
