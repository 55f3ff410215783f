#include <algorithm>
#include <array>

#include "apps/config/settings_table.h"

// The part of the table that holds the laws' parameters: servo.<controller>.<gain>.

namespace lineservo::apps {

void SettingsTable::gain(const std::string& prefix, servo::AdaptiveGain& g) {
  number(prefix + ".gain_at_zero", g.at_zero, 0.01, 20.0);
  number(prefix + ".gain_at_infinity", g.at_infinity, 0.01, 20.0);
  number(prefix + ".gain_slope", g.slope_at_zero, 0.0, 100.0);
}

void SettingsTable::interaction(std::string key, servo::InteractionMatrix& value) {
  constexpr std::array kNames = {"current", "desired", "mean"};  // in the order of the enumerators
  const auto set = [&value, kNames](const std::string& text) {
    const auto it = std::find(kNames.begin(), kNames.end(), text);
    if (it == kNames.end()) return false;
    value = static_cast<servo::InteractionMatrix>(it - kNames.begin());
    return true;
  };
  table_.push_back({std::move(key), "one of current, desired, mean", set,
                    [&value, kNames] { return std::string(kNames.at(static_cast<std::size_t>(value))); }});
}

void SettingsTable::bind_laws(servo::LawOptions& l) {
  bind_ibvs(l.ibvs);
  bind_ibvs_point("servo.ibvs-centroid", l.ibvs_centroid);
  bind_ibvs_point("servo.ibvs-point", l.ibvs_point);
  bind_pid(l.pid);
  bind_grid(l.grid);
  bind_lfpf(l.lfpf);
  bind_carrot(l.carrot);
  bind_improved_carrot(l.improved_carrot);
  bind_vtp(l.vtp);
  bind_own(l);
}

void SettingsTable::bind_own(servo::LawOptions& l) {
  for (const servo::Controller& controller : servo::controllers()) {
    for (const servo::OwnGain& gain : controller.gains) {
      const std::string key = controller.name + "." + gain.name;
      number("servo." + key, l.own.try_emplace(key, gain.value).first->second, gain.low, gain.high);
    }
  }
}

void SettingsTable::bind_ibvs(servo::IbvsLineOptions& o) {
  gain("servo.ibvs", o.gain);
  interaction("servo.ibvs.interaction_matrix", o.interaction);
  number("servo.ibvs.drift_time_constant_s", o.drift_time_constant_s, 0.05, 60.0);
  number("servo.ibvs.drift_limit_m_s", o.drift_limit_m_s, 0.0, 2.0);
  number("servo.ibvs.coast_s", o.coast_s, 0.0, 5.0);
  number("servo.ibvs.view_margin", o.view_margin, 0.05, 2.0);
  number("servo.ibvs.view_angle_rad", o.view_angle_rad, 0.05, 1.5);
  number("servo.ibvs.bend_acceleration_m_s2", o.bend_acceleration_m_s2, 0.05, 10.0);
  number("servo.ibvs.bend_yaw_rate_rad_s", o.bend_yaw_rate_rad_s, 0.05, 3.0);
}

void SettingsTable::bind_ibvs_point(const std::string& prefix, servo::IbvsPointOptions& o) {
  gain(prefix, o.gain);
  number(prefix + ".drift_time_constant_s", o.drift_time_constant_s, 0.05, 60.0);
  number(prefix + ".junction_drift_time_constant_s", o.junction_drift_time_constant_s, 0.05, 60.0);
  number(prefix + ".drift_limit_m_s", o.drift_limit_m_s, 0.0, 2.0);
  number(prefix + ".coast_s", o.coast_s, 0.0, 5.0);
  number(prefix + ".view_margin", o.view_margin, 0.05, 2.0);
}

void SettingsTable::bind_pid(servo::PidOptions& o) {
  number("servo.pid.kp", o.kp, 0.0, 100.0);
  number("servo.pid.ki", o.ki, 0.0, 100.0);
  number("servo.pid.kd", o.kd, 0.0, 100.0);
  number("servo.pid.integral_limit", o.integral_limit, 0.0, 1000.0);
  number("servo.pid.dead_zone", o.dead_zone, 0.0, 1.0);
  number("servo.pid.yaw_gamma_px_m", o.yaw_gamma_px_m, 0.0, 1000.0);
  number("servo.pid.yaw_clip_px", o.yaw_clip_px, 1.0, 200.0);
  number("servo.pid.yaw_focal_px", o.yaw_focal_px, 1.0, 10000.0);
  number("servo.pid.yaw_rate_limit_rad_s", o.yaw_rate_limit_rad_s, 0.0, 10.0);
}

void SettingsTable::bind_vtp(servo::VtpOptions& o) {
  number("servo.vtp.step_m_per_px", o.step_m_per_px, 1e-5, 1.0);
  number("servo.vtp.change_m_per_px", o.change_m_per_px, 0.0, 1.0);
  number("servo.vtp.change_px", o.change_px, 0.0, 100.0);
  number("servo.vtp.arc_px", o.arc_px, 1.0, 1000.0);
  number("servo.vtp.period_s", o.period_s, 0.02, 2.0);
  number("servo.vtp.marker_step_m_per_px", o.marker_step_m_per_px, 1e-5, 1.0);
}

void SettingsTable::pid_gains(const std::string& prefix, servo::PidGains& g) {
  number(prefix + "_kp", g.kp, 0.0, 100.0);
  number(prefix + "_ki", g.ki, 0.0, 100.0);
  number(prefix + "_kd", g.kd, 0.0, 100.0);
}

void SettingsTable::bind_grid(servo::GridOptions& o) {
  pid_gains("servo.grid.roll", o.roll);
  pid_gains("servo.grid.pitch", o.pitch);
  pid_gains("servo.grid.yaw", o.yaw);
  number("servo.grid.tilt_limit_deg", o.tilt_limit_deg, 0.01, 30.0);
  number("servo.grid.yaw_rate_limit_deg_s", o.yaw_rate_limit_deg_s, 0.01, 180.0);
  number("servo.grid.trim_rad_per_m_s", o.trim_rad_per_m_s, 0.0, 1.0);
}

void SettingsTable::bind_lfpf(servo::LfpfOptions& o) {
  number("servo.lfpf.c1_deg", o.c1_deg, 0.0, 30.0);
  number("servo.lfpf.c2_deg", o.c2_deg, 0.0, 30.0);
  number("servo.lfpf.b_deg", o.b_deg, 0.0, 30.0);
  number("servo.lfpf.sigmoid_px", o.sigmoid_px, 1.0, 10000.0);
  number("servo.lfpf.pitch_speed_m_s", o.pitch_speed_m_s, 0.001, 10.0);
  number("servo.lfpf.yaw_gain_per_s", o.yaw_gain_per_s, 0.0, 20.0);
  number("servo.lfpf.speed_hold_rad_per_m_s", o.speed_hold_rad_per_m_s, 0.0, 1.0);
}

void SettingsTable::bind_carrot(servo::CarrotOptions& o) {
  number("servo.carrot.delta_px", o.delta_px, 1.0, 10000.0);
  number("servo.carrot.kappa_per_s", o.kappa_per_s, 0.0, 20.0);
  number("servo.carrot.pitch_deg", o.pitch_deg, 0.0, 30.0);
  number("servo.carrot.pitch_speed_m_s", o.pitch_speed_m_s, 0.001, 10.0);
  number("servo.carrot.speed_hold_rad_per_m_s", o.speed_hold_rad_per_m_s, 0.0, 1.0);
}

void SettingsTable::bind_improved_carrot(servo::ImprovedCarrotOptions& o) {
  number("servo.improved-carrot.c1", o.c1, 0.0, 10.0);
  number("servo.improved-carrot.c2", o.c2, 0.0, 10.0);
  number("servo.improved-carrot.delta_px", o.delta_px, 1.0, 10000.0);
  number("servo.improved-carrot.channel_us", o.channel_us, 1.0, 10000.0);
  number("servo.improved-carrot.kappa_per_s", o.kappa_per_s, 0.0, 20.0);
  number("servo.improved-carrot.pitch_deg", o.pitch_deg, 0.01, 30.0);
  number("servo.improved-carrot.pitch_speed_m_s", o.pitch_speed_m_s, 0.001, 10.0);
  number("servo.improved-carrot.speed_hold_rad_per_m_s", o.speed_hold_rad_per_m_s, 0.0, 1.0);
}

}  // namespace lineservo::apps
