#include "apps/config/settings_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "apps/config/input_error.h"
#include "apps/config/numbers.h"
#include "features/detect/segmenters.h"
#include "features/line/line_methods.h"

namespace lineservo::apps {
namespace {

constexpr std::size_t kNearest = 4;

/// Levenshtein's distance: letters to put in, take out or exchange.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);  // from the first i letters of a to the first j of b
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// The keys that an unknown one may be meant to be, the likeliest first.
std::string nearest_keys(const std::vector<Setting>& table, const std::string& unknown) {
  std::vector<std::string> keys;
  for (const Setting& s : table) keys.push_back(s.key);
  std::ranges::stable_sort(keys, {}, [&](const std::string& key) { return edit_distance(key, unknown); });
  keys.resize(std::min(keys.size(), kNearest));
  return fmt::format("{}", fmt::join(keys, ", "));
}

}  // namespace

SettingsTable::SettingsTable(Settings& settings) {
  bind_general(settings);
  bind_wind(settings.wind);
  bind_camera(settings.camera);
  bind_floor(settings.floor);
  bind_features(settings.features);
  bind_sensors(settings.sensors);
  bind_vehicle(settings.airframe);
  whole("vehicle.weak_motor.rotor", settings.weak_motor.rotor, 1, vehicle::kRotors);
  number("vehicle.weak_motor.thrust_factor", settings.weak_motor.thrust_factor, 0.3, 1.0);
  bind_autopilot(settings.autopilot);
  bind_laws(settings.laws);
  bind_executive(settings.executive);
  bind_faults(settings.faults);
}

void SettingsTable::bind_general(Settings& s) {
  number("speed_m_s", s.speed_m_s, 0.01, 2.0);
  number("height_m", s.height_m, 0.2, 3.0);
  number("time_limit_s", s.time_limit_s, 1.0, 36000.0);
  number("start.position_spread_m", s.start.position_spread_m, 0.0, 0.5);
  number("start.heading_spread_deg", s.start.heading_spread_deg, 0.0, 30.0);
}

void SettingsTable::bind_wind(WindSettings& w) {
  number("wind.mean_m_s", w.mean_m_s, 0.0, 10.0);
  number("wind.direction_deg", w.direction_deg, -360.0, 360.0);
  number("wind.direction_spread_deg", w.direction_spread_deg, 0.0, 180.0);
  number("wind.turbulence_m_s", w.turbulence_m_s, 0.0, 5.0);
  number("wind.turbulence_height_m", w.turbulence_height_m, 0.1, 300.0);
  number("wind.gust.speed_m_s", w.gust.speed_m_s, -10.0, 10.0);
  number("wind.gust.start_s", w.gust.start_s, 0.0, 3600.0);
  number("wind.gust.duration_s", w.gust.duration_s, 0.1, 60.0);
}

void SettingsTable::bind_camera(CameraSettings& c) {
  whole("camera.width_px", c.width_px, 64, 4096);
  whole("camera.height_px", c.height_px, 64, 4096);
  number("camera.focal_px", c.focal_px, 10.0, 20000.0);
  number("camera.k1", c.distortion[0], -1.0, 1.0);
  number("camera.k2", c.distortion[1], -1.0, 1.0);
  number("camera.p1", c.distortion[2], -0.1, 0.1);
  number("camera.p2", c.distortion[3], -0.1, 0.1);
  number("camera.k3", c.distortion[4], -1.0, 1.0);
  number("camera.frame_rate_hz", c.frame_rate_hz, 1.0, 240.0);
  number("camera.latency_s", c.latency_s, 0.0, 0.5);
  number("camera.latency_jitter_s", c.latency_jitter_s, 0.0, 0.1);
  number("camera.drop_share", c.drop_share, 0.0, 0.9);
  number("camera.latency_error_s", c.latency_error_s, 0.0, 0.1);
  number("camera.exposure_s", c.shutter.exposure_s, 0.0, 0.1);
  whole("camera.exposure_samples", c.shutter.samples, 1, vehicle::ShutterOptions::kMostSamples);
  number("camera.readout_s", c.shutter.readout_s, 0.0, 0.1);
  number("camera.noise_levels", c.noise_levels, 0.0, 25.0);
  number("camera.mount_tilt_deg", c.mount_tilt_deg, 0.0, 10.0);
}

void SettingsTable::bind_floor(FloorSettings& f) {
  number("floor.worn_share", f.wear.worn_share, 0.0, 0.9);
  number("floor.gap_m", f.wear.gap_m, 0.0, 1.0);
  number("floor.gap_every_m", f.wear.gap_every_m, 0.2, 1000.0);
  number("floor.dirt_share", f.wear.dirt_share, 0.0, 0.5);
  number("floor.objects_per_m2", f.wear.objects_per_m2, 0.0, 20.0);
  number("light.low", f.light.low, 0.05, 2.0);
  number("light.high", f.light.high, 0.05, 2.0);
  number("light.wavelength_m", f.light.wavelength_m, 0.5, 100.0);
  number("light.glare", f.light.glare, 0.0, 1.0);
  number("light.glare_radius_m", f.light.glare_radius_m, 0.02, 1.0);
  number("light.glare_every_m", f.light.glare_every_m, 1.0, 100.0);
  number("light.shadow", f.light.shadow, 0.0, 0.9);
  number("light.shadow_radius_m", f.light.shadow_radius_m, 0.02, 2.0);
  number("light.shadow_offset", f.light.shadow_offset, 0.0, 2.0);
}

void SettingsTable::bind_features(FeatureSettings& f) {
  word("features.junction.method", f.junction_method, {"auto", "fpd", "stripe"});
  whole("features.junction.window", f.junction_window, {1, 3, 5, 7, 9});
  std::vector<std::string> segmenters;
  for (const std::string_view name : features::segmenter_names()) segmenters.emplace_back(name);
  word("features.segmenter", f.segmenter, segmenters);
  word("features.marker", f.marker, {"red", "eroded"});
  number("features.difference.green_divisor", f.difference.green_divisor, 1.0, 255.0);
  number("features.difference.blue_divisor", f.difference.blue_divisor, 1.0, 255.0);
  number("features.difference.threshold", f.difference.threshold, 0.0, 255.0);
  whole("features.difference.erosion_px", f.difference.erosion_px, 1, 64);
  std::vector<std::string> methods;
  for (const features::LineMethod& method : features::line_methods()) methods.emplace_back(method.name);
  word("features.line.method", f.line_method, methods);
  word("features.line.filter", f.line_filter, {"none", "kalman"});
  yes_no("features.tilt_correction", f.tilt_correction);
  number("features.target.arc_half_widths", f.arc_half_widths, 0.5, 20.0);
}

void SettingsTable::bind_sensors(SensorSettings& s) {
  number("sensors.gyro_sigma_deg_s", s.gyro_sigma_deg_s, 0.0, 10.0);
  number("sensors.gyro_bias_deg_s", s.gyro_bias_deg_s, 0.0, 5.0);
  number("sensors.accelerometer_sigma_m_s2", s.accelerometer_sigma_m_s2, 0.0, 5.0);
  number("sensors.accelerometer_bias_m_s2", s.accelerometer_bias_m_s2, 0.0, 1.0);
  number("sensors.attitude_sigma_deg", s.attitude_sigma_deg, 0.0, 5.0);
  number("sensors.tilt_bias_deg", s.tilt_bias_deg, 0.0, 5.0);
  number("sensors.velocity_sigma_m_s", s.velocity_sigma_m_s, 0.0, 1.0);
  number("sensors.velocity_bias_m_s", s.velocity_bias_m_s, 0.0, 0.5);
  number("sensors.velocity_bias_start_m_s", s.velocity_bias_start_m_s, 0.0, 0.5);
  number("sensors.range_sigma_m", s.range_sigma_m, 0.0, 0.5);
}

void SettingsTable::bind_vehicle(vehicle::AirframeParameters& a) {
  number("vehicle.mass_kg", a.mass_kg, 0.02, 20.0);
  number("vehicle.inertia_x_kg_m2", a.inertia_kg_m2.x(), 1e-6, 5.0);
  number("vehicle.inertia_y_kg_m2", a.inertia_kg_m2.y(), 1e-6, 5.0);
  number("vehicle.inertia_z_kg_m2", a.inertia_kg_m2.z(), 1e-6, 5.0);
  number("vehicle.thrust_coefficient_N_s2", a.thrust_coefficient_N_s2, 1e-10, 1e-2);
  number("vehicle.moment_coefficient_m", a.moment_coefficient_m, 1e-4, 1.0);
  number("vehicle.max_rotor_speed_rad_s", a.max_rotor_speed_rad_s, 100.0, 10000.0);
  number("vehicle.rotor_drag_N_per_rad_s_m_s", a.rotor_drag_N_per_rad_s_m_s, 0.0, 0.01);
  number("vehicle.motor_lag_up_s", a.motor_lag_up_s, 1e-4, 0.5);
  number("vehicle.motor_lag_down_s", a.motor_lag_down_s, 1e-4, 0.5);
  number("vehicle.rotor_radius_m", a.rotor_radius_m, 0.01, 1.0);
  bind_rotor_places(a);
  number("vehicle.gear_height_m", a.gear_height_m, 0.005, 1.0);
  number("vehicle.body_half_length_m", a.collision_half_extents_m.x(), 0.01, 2.0);
  number("vehicle.body_half_width_m", a.collision_half_extents_m.y(), 0.01, 2.0);
  number("vehicle.body_half_height_m", a.collision_half_extents_m.z(), 0.005, 1.0);
  number("vehicle.body_drag_area_m2", a.body_drag_area_m2, 0.0, 1.0);
  number("vehicle.mass_factor", a.load_factor, 0.5, 2.0);
}

// In the order of AirframeParameters::rotors, which weak_motor.rotor counts.
void SettingsTable::bind_rotor_places(vehicle::AirframeParameters& a) {
  for (std::size_t k = 0; k < a.rotors.size(); ++k) {
    number(fmt::format("vehicle.rotor_{}.x_m", k + 1), a.rotors[k].x_m, -2.0, 2.0);
    number(fmt::format("vehicle.rotor_{}.y_m", k + 1), a.rotors[k].y_m, -2.0, 2.0);
  }
}

void SettingsTable::bind_autopilot(vehicle::AutopilotOptions& o) {
  number("vehicle.believed_mass_ratio", o.believed_mass_ratio, 0.5, 2.0);
  number("limits.tilt_rad", o.limits.max_tilt_rad, 0.05, 0.8);
  number("limits.horizontal_speed_m_s", o.limits.max_horizontal_speed_m_s, 0.1, 10.0);
  number("limits.vertical_speed_m_s", o.limits.max_vertical_speed_m_s, 0.1, 5.0);
  number("limits.yaw_rate_rad_s", o.limits.max_yaw_rate_rad_s, 0.1, 10.0);
  number("limits.height_m", o.limits.max_height_m, 0.3, 20.0);
  number("limits.blind_travel_m", o.limits.max_blind_travel_m, 0.1, 20.0);
}

void SettingsTable::bind_executive(servo::ExecutiveOptions& e) {
  gain("servo.dock", e.dock.gain);
  number("servo.dock.drift_time_constant_s", e.dock.drift_time_constant_s, 0.05, 60.0);
  number("servo.dock.drift_limit_m_s", e.dock.drift_limit_m_s, 0.0, 2.0);
  number("executive.leaving_heights", e.leaving_heights, 0.1, 3.0);
  whole("executive.confirm_frames", e.confirm_frames, 1, 30);
  number("executive.climb_rate_m_s", e.climb_rate_m_s, 0.05, 2.0);
  number("executive.approach_deceleration_m_s2", e.approach.deceleration_m_s2, 0.01, 5.0);
  number("executive.approach_response_s", e.approach.response_s, 0.0, 2.0);
  number("executive.approach_speed_m_s", e.approach.speed_m_s, 0.01, 1.0);
  number("executive.corner_deviation_m", e.corner.deviation_m, 0.0, 0.3);
  number("executive.corner_acceleration_m_s2", e.corner.acceleration_m_s2, 0.01, 5.0);
  number("executive.turn_rate_rad_s", e.turn.rate_limit_rad_s, 0.05, 3.0);
  number("executive.turn_gain_per_s", e.turn.gain_per_s, 0.1, 10.0);
  number("executive.turn_acceleration_rad_s2", e.turn.acceleration_rad_s2, 0.05, 10.0);
  number("executive.acceleration_m_s2", e.limits.acceleration_m_s2, 0.1, 10.0);
  number("executive.yaw_acceleration_rad_s2", e.limits.yaw_acceleration_rad_s2, 0.1, 20.0);
  number("executive.hover_s", e.phases.hover_s, 2.5, 600.0);
  number("executive.line_memory_s", e.phases.line_memory_s, 0.1, 10.0);
  number("executive.length_tolerance", e.phases.length_tolerance, 0.0, 1.0);
  number("executive.length_slack_m", e.phases.length_slack_m, 0.0, 5.0);
  number("executive.align_limit_s", e.phases.align_limit_s, 1.0, 600.0);
  number("executive.odometry_drift_m_s", e.phases.odometry_drift_m_s, 0.0, 1.0);
  whole("executive.doubt_frames", e.doubt_frames, 0, 30);
  number("executive.endurance_s", e.phases.endurance_s, 20.0, 36000.0);
  number("executive.sensor_memory_s", e.phases.sensor_memory_s, 0.2, 10.0);
  number("executive.dock_distance_m", e.phases.dock_distance_m, 0.001, 0.3);
  number("executive.dock_speed_m_s", e.phases.dock_speed_m_s, 0.001, 1.0);
}

void SettingsTable::bind_faults(FaultSettings& f) {
  window("faults.camera_black", f.frames.black);
  window("faults.camera_frozen", f.frames.frozen);
  window("faults.camera_silent", f.frames.silent);
  window("faults.frames_late", f.frames.late);
  window("faults.frames_twice", f.frames.twice);
  window("faults.range_silent", f.sensors.range_silent);
  window("faults.range_frozen", f.sensors.range_frozen);
  window("faults.range_wild", f.sensors.range_wild);
  window("faults.velocity_silent", f.sensors.velocity_silent);
  window("faults.attitude_silent", f.sensors.attitude_silent);
  window("faults.gyro_wild", f.sensors.gyro_wild);
  window("faults.sensors_nan", f.sensors.not_a_number);
  window("faults.features_nan", f.software.features_nan);
  window("faults.estimate_nan", f.software.estimate_nan);
  window("faults.law_nan", f.software.law_nan);
  window("faults.misread", f.software.misread);
  word("faults.misread.code", f.misread_code, {"J2", "J3", "J4", "J5", "J6", "J7", "J8", "J9"});
  number("faults.cover.x_m", f.cover_x_m, -1e4, 1e4);
  number("faults.cover.y_m", f.cover_y_m, -1e4, 1e4);
  number("faults.cover.radius_m", f.cover_radius_m, 0.0, 100.0);
  number("faults.branch.x_m", f.branch_x_m, -1e4, 1e4);
  number("faults.branch.y_m", f.branch_y_m, -1e4, 1e4);
  number("faults.branch.heading_deg", f.branch_heading_deg, -360.0, 360.0);
  number("faults.branch.length_m", f.branch_length_m, 0.0, 100.0);
}

void SettingsTable::window(const std::string& key, vehicle::FaultWindow& value) {
  number(key + ".start_s", value.start_s, 0.0, 36000.0);
  number(key + ".duration_s", value.duration_s, 0.0, 36000.0);
}

void SettingsTable::set(const std::string& key, const std::string& text, const std::string& where) {
  const auto it =
      std::find_if(table_.begin(), table_.end(), [&key](const Setting& s) { return s.key == key; });
  if (it == table_.end()) {
    throw InputError(fmt::format("{}: unknown key '{}'; near it: {}", where, key, nearest_keys(table_, key)));
  }
  if (!it->set(text))
    throw InputError(fmt::format("{}: '{}' must be {}, not '{}'", where, key, it->allowed, text));
}

void SettingsTable::number(std::string key, double& value, double low, double high) {
  const auto set = [&value, low, high](const std::string& text) {
    const std::optional<double> parsed = parse_number(text, low, high);
    if (!parsed) return false;
    value = *parsed;
    return true;
  };
  table_.push_back({std::move(key), fmt::format("a number from {} to {}", low, high), set,
                    [&value] { return fmt::format("{}", value); }, NumberRange{low, high}});
}

void SettingsTable::whole(std::string key, int& value, int low, int high) {
  const auto set = [&value, low, high](const std::string& text) {
    const std::optional<int> parsed = parse_number(text, low, high);
    if (!parsed) return false;
    value = *parsed;
    return true;
  };
  table_.push_back({std::move(key), fmt::format("a whole number from {} to {}", low, high), set,
                    [&value] { return fmt::format("{}", value); }});
}

void SettingsTable::whole(std::string key, int& value, std::vector<int> choices) {
  const std::string allowed = fmt::format("one of {}", fmt::join(choices, ", "));
  const auto set = [&value, choices = std::move(choices)](const std::string& text) {
    const auto parsed = parse_number<int>(text, 0, std::numeric_limits<int>::max());
    if (!parsed || std::find(choices.begin(), choices.end(), *parsed) == choices.end()) return false;
    value = *parsed;
    return true;
  };
  table_.push_back({std::move(key), allowed, set, [&value] { return fmt::format("{}", value); }});
}

void SettingsTable::word(std::string key, std::string& value, std::vector<std::string> choices) {
  const std::string allowed = fmt::format("one of {}", fmt::join(choices, ", "));
  const auto set = [&value, choices = std::move(choices)](const std::string& text) {
    if (std::find(choices.begin(), choices.end(), text) == choices.end()) return false;
    value = text;
    return true;
  };
  table_.push_back({std::move(key), allowed, set, [&value] { return value; }});
}

void SettingsTable::yes_no(std::string key, bool& value) {
  const auto set = [&value](const std::string& text) {
    if (text != "true" && text != "false") return false;
    value = text == "true";
    return true;
  };
  table_.push_back(
      {std::move(key), "true or false", set, [&value] { return std::string(value ? "true" : "false"); }});
}

}  // namespace lineservo::apps
