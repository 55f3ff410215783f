#include "apps/config/settings_table.h"

// The part of the table that holds the laws' parameters: servo.<controller>.<gain>.

namespace lineservo::apps {

void SettingsTable::gain(const std::string& prefix, servo::AdaptiveGain& g) {
  number(prefix + ".gain_at_zero", g.at_zero, 0.01, 20.0);
  number(prefix + ".gain_at_infinity", g.at_infinity, 0.01, 20.0);
  number(prefix + ".gain_slope", g.slope_at_zero, 0.0, 100.0);
}

void SettingsTable::bind_laws(servo::LawOptions& l) {
  bind_ibvs(l.ibvs);
  bind_pid(l.pid);
}

void SettingsTable::bind_ibvs(servo::IbvsLineOptions& o) {
  gain("servo.ibvs", o.gain);
  number("servo.ibvs.drift_time_constant_s", o.drift_time_constant_s, 0.05, 60.0);
  number("servo.ibvs.drift_limit_m_s", o.drift_limit_m_s, 0.0, 2.0);
  number("servo.ibvs.coast_s", o.coast_s, 0.0, 5.0);
  number("servo.ibvs.view_margin", o.view_margin, 0.05, 2.0);
  number("servo.ibvs.view_angle_rad", o.view_angle_rad, 0.05, 1.5);
}

void SettingsTable::bind_pid(servo::PidOptions& o) {
  number("servo.pid.kp", o.kp, 0.0, 100.0);
  number("servo.pid.ki", o.ki, 0.0, 100.0);
  number("servo.pid.kd", o.kd, 0.0, 100.0);
  number("servo.pid.integral_limit", o.integral_limit, 0.0, 1000.0);
  number("servo.pid.dead_zone", o.dead_zone, 0.0, 1.0);
}

}  // namespace lineservo::apps
