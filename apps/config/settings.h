#pragma once

#include <array>
#include <string>

#include "apps/flight/software_faults.h"
#include "features/mask/difference_segmenter.h"
#include "features/mask/segmenter_options.h"
#include "servo/executive/executive.h"
#include "servo/law/controllers.h"
#include "vehicle/autopilot/options.h"
#include "vehicle/body/airframe.h"
#include "vehicle/body/weather.h"
#include "vehicle/floor/floor_look.h"
#include "vehicle/floor/frame_faults.h"
#include "vehicle/floor/shutter_options.h"
#include "vehicle/sensors/sensor_faults.h"

namespace lineservo::apps {

/// The camera that is simulated, and the way of its frames to the laws.
struct CameraSettings {
  int width_px = 640;
  int height_px = 480;
  double focal_px = 320.0;
  std::array<double, 5> distortion = {0.0, 0.0, 0.0, 0.0, 0.0};  ///< k1, k2, p1, p2, k3
  double frame_rate_hz = 30.0;
  double latency_s = 0.0;
  double latency_jitter_s = 0.0;  ///< bound of how far a frame is off the latency
  double drop_share = 0.0;        ///< of the frames, lost on the way
  double latency_error_s = 0.0;   ///< bound of what the law takes the latency for, less what it is
  vehicle::ShutterOptions shutter;
  double noise_levels = 0.0;    ///< standard deviation, in levels of 255
  double mount_tilt_deg = 0.0;  ///< off its place, towards a side that the seed says
};

/// How perception looks at a frame; the words are those of the keys features.*.
struct FeatureSettings {
  std::string junction_method = "auto";  ///< "fpd", "stripe", or "auto": the controller's own
  int junction_window = 5;
  std::string segmenter = "hsv";
  std::string marker = "red";
  features::DifferenceOptions difference;
  std::string line_method = "stripe";
  std::string line_filter = "none";  ///< "none" or "kalman"
  bool tilt_correction = true;
  double arc_half_widths = 1.6;  ///< radius of the target point's arc, in halves of the stripe's width
};

/// How the floor looks to the camera; the names in the files are those of the options.
using FloorSettings = vehicle::FloorLook;

/// As in the files: degrees where the key says so.
struct SensorSettings {
  double gyro_sigma_deg_s = 0.0;
  double gyro_bias_deg_s = 0.0;
  double accelerometer_sigma_m_s2 = 0.0;
  double accelerometer_bias_m_s2 = 0.0;
  double attitude_sigma_deg = 0.0;
  double tilt_bias_deg = 0.0;
  double velocity_sigma_m_s = 0.0;
  double velocity_bias_m_s = 0.0;
  double velocity_bias_start_m_s = 0.0;
  double range_sigma_m = 0.0;
};

/// Mean wind, turbulence and one gust.
struct WindSettings {
  double mean_m_s = 0.0;
  double direction_deg = 0.0;         ///< where it blows to, from +x
  double direction_spread_deg = 0.0;  ///< bound of how far off that, drawn from the seed
  double turbulence_m_s = 0.0;
  double turbulence_height_m = 0.5;
  vehicle::GustParameters gust;
};

/// One motor that is weaker than the others.
struct WeakMotorSettings {
  int rotor = 1;  ///< front right, rear left, front left, rear right
  double thrust_factor = 1.0;
};

/// What goes wrong in the flight; nothing unless it is given a duration, a radius or a length.
struct FaultSettings {
  vehicle::FrameFaultOptions frames;
  vehicle::SensorFaultOptions sensors;
  SoftwareFaultOptions software;
  std::string misread_code = "J3";
  double cover_x_m = 0.0, cover_y_m = 0.0, cover_radius_m = 0.0;
  double branch_x_m = 0.0, branch_y_m = 0.0, branch_heading_deg = 0.0, branch_length_m = 0.0;
};

/// How far off the start node the vehicle is placed, drawn from the seed within these bounds.
struct StartSettings {
  double position_spread_m = 0.10;
  double heading_spread_deg = 5.0;
};

/// Everything that can be set for a flight; the defaults are the conditions `ideal`.
struct Settings {
  double speed_m_s = 0.3;
  double height_m = 0.5;
  double time_limit_s = 900.0;
  CameraSettings camera;
  FloorSettings floor;
  FeatureSettings features;
  SensorSettings sensors;
  WindSettings wind;
  StartSettings start;
  WeakMotorSettings weak_motor;
  FaultSettings faults;
  vehicle::AirframeParameters airframe;
  vehicle::AutopilotOptions autopilot;
  servo::LawOptions laws;
  servo::ExecutiveOptions executive;
};

}  // namespace lineservo::apps
