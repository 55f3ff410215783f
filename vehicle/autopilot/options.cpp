#include "vehicle/autopilot/options.h"

#include "vehicle/faults.h"

namespace lineservo::vehicle {

void AutopilotOptions::validate() const {
  Faults faults("autopilot");
  faults.require(limits.max_tilt_rad > 0.0 && limits.max_tilt_rad <= 0.8,
                 "max_tilt_rad must be above 0 and at most 0.8");
  faults.require_positive(limits.max_horizontal_speed_m_s, "max_horizontal_speed_m_s");
  faults.require_positive(limits.max_vertical_speed_m_s, "max_vertical_speed_m_s");
  faults.require_positive(limits.max_yaw_rate_rad_s, "max_yaw_rate_rad_s");
  faults.require_positive(limits.max_height_m, "max_height_m");
  faults.require_positive(limits.max_blind_travel_m, "max_blind_travel_m");
  faults.require(believed_mass_ratio >= 0.5 && believed_mass_ratio <= 2.0,
                 "believed_mass_ratio must be from 0.5 to 2");
  faults.require_positive(horizontal_acceleration_m_s2, "horizontal_acceleration_m_s2");
  faults.require(vertical_acceleration_m_s2 > 0.0 && vertical_acceleration_m_s2 <= 8.0,
                 "vertical_acceleration_m_s2 must be above 0 and at most 8");
  faults.require_positive(descent_speed_m_s, "descent_speed_m_s");
  faults.require(touchdown_speed_m_s > 0.0 && touchdown_speed_m_s <= 0.5,
                 "touchdown_speed_m_s must be above 0 and at most 0.5");
  faults.throw_if_any();
}

}  // namespace lineservo::vehicle
