#pragma once

#include "servo/task/command.h"

namespace lineservo::servo {

/// Bounds of what the laws may ask for.
struct CommandLimits {
  double horizontal_m_s = 1.5;
  double vertical_m_s = 0.5;
  double yaw_rate_rad_s = 1.2;
  double acceleration_m_s2 = 8.0;  ///< change of the horizontal velocity; what the tilt allows is below
  double yaw_acceleration_rad_s2 = 4.0;
};

/// Scales the horizontal velocity and clamps the rest, directions kept.
VelocityCommand saturate(VelocityCommand command, const CommandLimits& limits);

/// Moves from one velocity command towards another no faster than the limits allow in dt: the hand-over
/// between two tasks has no jump.
VelocityCommand approach(const VelocityCommand& from, const VelocityCommand& to, const CommandLimits& limits,
                         double dt_s);

}  // namespace lineservo::servo
