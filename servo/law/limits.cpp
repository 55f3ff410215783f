#include "servo/law/limits.h"

#include <algorithm>
#include <cmath>

namespace lineservo::servo {
namespace {

double stepped(double from, double to, double limit) {
  return from + std::clamp(to - from, -limit, limit);
}

}  // namespace

VelocityCommand saturate(VelocityCommand command, const CommandLimits& limits) {
  const double speed = std::hypot(command.forward_m_s, command.left_m_s);
  const double scale = speed > limits.horizontal_m_s ? limits.horizontal_m_s / speed : 1.0;
  return {command.forward_m_s * scale, command.left_m_s * scale,
          std::clamp(command.up_m_s, -limits.vertical_m_s, limits.vertical_m_s),
          std::clamp(command.yaw_rate_rad_s, -limits.yaw_rate_rad_s, limits.yaw_rate_rad_s)};
}

VelocityCommand approach(const VelocityCommand& from, const VelocityCommand& to, const CommandLimits& limits,
                         double dt_s) {
  const double dx = to.forward_m_s - from.forward_m_s, dy = to.left_m_s - from.left_m_s;
  const double change = std::hypot(dx, dy), allowed = limits.acceleration_m_s2 * dt_s;
  const double share = change > allowed ? allowed / change : 1.0;
  return {from.forward_m_s + share * dx, from.left_m_s + share * dy,
          stepped(from.up_m_s, to.up_m_s, limits.acceleration_m_s2 * dt_s),
          stepped(from.yaw_rate_rad_s, to.yaw_rate_rad_s, limits.yaw_acceleration_rad_s2 * dt_s)};
}

}  // namespace lineservo::servo
