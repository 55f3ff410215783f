#pragma once

#include <variant>

namespace lineservo::servo {

/// Velocity in the heading frame H (x forward, y left, z up, level) and yaw rate (counter-clockwise from
/// above).
struct VelocityCommand {
  double forward_m_s = 0.0;
  double left_m_s = 0.0;
  double up_m_s = 0.0;
  double yaw_rate_rad_s = 0.0;
};

/// What attitude-level followers command (lfpf Alg. 2–3): roll > 0 right side down, pitch > 0 nose down.
struct AttitudeCommand {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rate_rad_s = 0.0;
  double height_m = 0.0;
};

/// Descend on the spot and stop the motors.
struct LandCommand {};

using Command = std::variant<VelocityCommand, AttitudeCommand, LandCommand>;

/// False when any value is NaN or infinite: such a command must not reach the vehicle.
bool is_finite(const Command& command);

}  // namespace lineservo::servo
