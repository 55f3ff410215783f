#include "apps/flight/convert.h"

#include <cmath>

#include "apps/config/data_folder.h"
#include "features/geometry/angles.h"
#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

constexpr double kAboveGear_m = 0.05;  // from where the autopilot lands by itself

using features::radians;

// Of the flight's seed; flight.cpp has the two before.
constexpr std::uint64_t kMountStream = 1002, kWindStream = 1003;

vehicle::Setpoint convert(const servo::VelocityCommand& c) {
  return vehicle::VelocitySetpoint{{c.forward_m_s, c.left_m_s, c.up_m_s}, c.yaw_rate_rad_s};
}
vehicle::Setpoint convert(const servo::AttitudeCommand& c) {
  return vehicle::AttitudeSetpoint{c.roll_rad, c.pitch_rad, c.yaw_rate_rad_s, c.height_m};
}
vehicle::Setpoint convert(const servo::LandCommand&) {
  return vehicle::LandSetpoint{};
}

Eigen::Vector2d mount_tilt_rad(double angle_deg, std::uint64_t seed) {
  const double side_rad = vehicle::Random(seed, kMountStream).uniform(0.0, 2.0 * features::kPi);
  return radians(angle_deg) * Eigen::Vector2d(std::cos(side_rad), std::sin(side_rad));
}

vehicle::RepaintOptions repaint_options(const FaultSettings& f) {
  vehicle::RepaintOptions repaint;
  repaint.cover_W = {f.cover_x_m, f.cover_y_m};
  repaint.cover_radius_m = f.cover_radius_m;
  repaint.branch_W = {f.branch_x_m, f.branch_y_m};
  repaint.branch_heading_rad = radians(f.branch_heading_deg);
  repaint.branch_length_m = f.branch_length_m;
  return repaint;
}

/// The recogniser that a controller flies with: the setting, or the controller's own.
std::string_view junction_method(const FeatureSettings& settings, const servo::Controller& controller) {
  return settings.junction_method == "auto" ? controller.junction_method
                                            : std::string_view(settings.junction_method);
}

}  // namespace

features::CameraParameters camera_parameters(const CameraSettings& settings) {
  features::CameraParameters camera;
  camera.width_px = settings.width_px;
  camera.height_px = settings.height_px;
  camera.fx_px = camera.fy_px = settings.focal_px;
  camera.cx_px = 0.5 * (settings.width_px - 1);
  camera.cy_px = 0.5 * (settings.height_px - 1);
  camera.distortion = settings.distortion;
  return camera;
}

vehicle::SyntheticCameraOptions camera_options(const Settings& all, std::uint64_t seed) {
  const CameraSettings& settings = all.camera;
  vehicle::SyntheticCameraOptions options;
  options.camera = camera_parameters(settings);
  options.look = all.floor;
  options.look.repaint = repaint_options(all.faults);
  options.shutter = settings.shutter;
  options.frame_rate_hz = settings.frame_rate_hz;
  options.link = {settings.latency_s, settings.latency_jitter_s, settings.drop_share};
  options.noise_sigma = settings.noise_levels / 255.0;
  options.mount_tilt_rad = mount_tilt_rad(settings.mount_tilt_deg, seed);
  return options;
}

SoftwareFaultOptions software_faults(const FaultSettings& settings) {
  SoftwareFaultOptions options = settings.software;
  for (int code = 0; code < features::kJunctionCodes; ++code) {
    const auto candidate = static_cast<features::JunctionCode>(code);
    if (features::name(candidate) == settings.misread_code) options.misread_code = candidate;
  }
  return options;
}

vehicle::SensorParameters sensor_parameters(const SensorSettings& settings) {
  vehicle::SensorParameters sensors = vehicle::SensorParameters::ideal();
  sensors.gyro_sigma_rad_s = radians(settings.gyro_sigma_deg_s);
  sensors.gyro_bias_rad_s = radians(settings.gyro_bias_deg_s);
  sensors.accelerometer_sigma_m_s2 = settings.accelerometer_sigma_m_s2;
  sensors.accelerometer_bias_m_s2 = settings.accelerometer_bias_m_s2;
  sensors.attitude_sigma_rad = radians(settings.attitude_sigma_deg);
  sensors.tilt_offset_rad = radians(settings.tilt_bias_deg);
  sensors.flow_sigma_m_s = settings.velocity_sigma_m_s;
  sensors.flow_bias_m_s = settings.velocity_bias_m_s;
  sensors.flow_bias_start_m_s = settings.velocity_bias_start_m_s;
  sensors.range_sigma_m = settings.range_sigma_m;
  return sensors;
}

vehicle::WeatherParameters weather_parameters(const WindSettings& settings, std::uint64_t seed) {
  vehicle::WeatherParameters weather;
  weather.mean_m_s = settings.mean_m_s;
  weather.direction_rad = radians(settings.direction_deg);
  if (settings.direction_spread_deg > 0.0) {
    const double spread_rad = radians(settings.direction_spread_deg);
    weather.direction_rad += vehicle::Random(seed, kWindStream).uniform(-spread_rad, spread_rad);
  }
  weather.turbulence_m_s = settings.turbulence_m_s;
  weather.turbulence_height_m = settings.turbulence_height_m;
  weather.gust = settings.gust;
  return weather;
}

vehicle::AirframeParameters airframe_parameters(const Settings& settings) {
  vehicle::AirframeParameters airframe = settings.airframe;
  airframe.thrust_factors[settings.weak_motor.rotor - 1] = settings.weak_motor.thrust_factor;
  return airframe;
}

features::PerceptionOptions perception_options(const FeatureSettings& settings,
                                               const servo::Controller& controller) {
  const std::string_view method = junction_method(settings, controller);
  features::PerceptionOptions options;
  options.needs = controller.needs;
  options.target.arc_half_widths = settings.arc_half_widths;
  options.line_method = settings.line_method;
  options.junction_method =
      method == "fpd" ? features::JunctionMethod::fpd : features::JunctionMethod::stripe;
  options.junction_window = settings.junction_window;
  options.path.name = settings.segmenter;
  options.path.difference = settings.difference;
  options.marker = settings.marker == "eroded" ? features::MarkerMethod::eroded : features::MarkerMethod::red;
  if (settings.segmenter == "svm") options.path.svm_model = shipped_text("models/yellow.yaml");
  options.line_filter =
      settings.line_filter == "kalman" ? features::LineFilter::kalman : features::LineFilter::none;
  return options;
}

servo::ExecutiveOptions executive_options(const Settings& settings, bool land) {
  servo::ExecutiveOptions options = settings.executive;
  options.speed_m_s = settings.speed_m_s;
  options.phases.height_m = settings.height_m;
  options.phases.land = land;
  options.touch_down_m = settings.airframe.gear_height_m + kAboveGear_m;
  return options;
}

vehicle::Setpoint to_setpoint(const servo::Command& command) {
  return std::visit([](const auto& c) { return convert(c); }, command);
}

}  // namespace lineservo::apps
