#pragma once

#include "apps/config/settings.h"
#include "features/geometry/camera_model.h"
#include "features/perception.h"
#include "servo/task/command.h"
#include "vehicle/floor/synthetic_camera.h"
#include "vehicle/sensors/sensor_parameters.h"
#include "vehicle/setpoint.h"

namespace lineservo::apps {

// From the settings of the files to the options of each side, and from one side to the other.

features::CameraParameters camera_parameters(const CameraSettings& settings);
/// The seed says to which side the camera is mounted off.
vehicle::SyntheticCameraOptions camera_options(const Settings& settings, std::uint64_t seed);
SoftwareFaultOptions software_faults(const FaultSettings& settings);
vehicle::SensorParameters sensor_parameters(const SensorSettings& settings);
vehicle::WeatherParameters weather_parameters(const WindSettings& settings, std::uint64_t seed);
vehicle::AirframeParameters airframe_parameters(const Settings& settings);
/// With the recogniser and the features that the controller flies with, unless the settings say otherwise.
features::PerceptionOptions perception_options(const FeatureSettings& settings,
                                               const servo::Controller& controller);
servo::ExecutiveOptions executive_options(const Settings& settings, bool land);

vehicle::Setpoint to_setpoint(const servo::Command& command);

}  // namespace lineservo::apps
