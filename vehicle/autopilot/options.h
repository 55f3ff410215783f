#pragma once

#include <numbers>

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// How long a command holds when it does not say.
inline constexpr Time kDefaultHold = std::chrono::milliseconds(300);

/// What no command can make the vehicle exceed.
struct SafetyLimits {
  double max_tilt_rad = 25.0 * std::numbers::pi / 180.0;
  double max_horizontal_speed_m_s = 2.0;
  double max_vertical_speed_m_s = 1.0;
  double max_yaw_rate_rad_s = 2.0;
  double max_height_m = 3.0;
  double max_blind_travel_m = 1.0;  ///< since paint was last in sight
};

/// What the autopilot may do, and what it takes the vehicle for.
struct AutopilotOptions {
  SafetyLimits limits;
  /// What the autopilot takes the mass for, over what it is: a payload that nobody told it of.
  double believed_mass_ratio = 1.0;
  double horizontal_acceleration_m_s2 = 4.0;  ///< on each axis
  double vertical_acceleration_m_s2 = 3.0;
  double descent_speed_m_s = 0.3;     ///< when landing
  double touchdown_speed_m_s = 0.15;  ///< for the last bit of it

  /// Throws one std::invalid_argument that lists every fault.
  void validate() const;
};

}  // namespace lineservo::vehicle
