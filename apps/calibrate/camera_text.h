#pragma once

#include <string>

#include "apps/calibrate/calibration.h"

namespace lineservo::apps {

/// ROS camera_info YAML with the lens plumb_bob; numbers read back bit for bit.
std::string ros_text(const features::CameraParameters& camera);

/// ViSP XML, as vpXmlParserCamera reads it, with the camera named "camera".
std::string visp_text(const VispCalibration& calibration);

}  // namespace lineservo::apps
