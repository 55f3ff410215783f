#include "servo/task/command.h"

#include <cmath>

namespace lineservo::servo {
namespace {

bool finite(const VelocityCommand& c) {
  return std::isfinite(c.forward_m_s) && std::isfinite(c.left_m_s) && std::isfinite(c.up_m_s) &&
         std::isfinite(c.yaw_rate_rad_s);
}
bool finite(const AttitudeCommand& c) {
  return std::isfinite(c.roll_rad) && std::isfinite(c.pitch_rad) && std::isfinite(c.yaw_rate_rad_s) &&
         std::isfinite(c.height_m);
}
bool finite(const LandCommand&) {
  return true;
}

}  // namespace

bool is_finite(const Command& command) {
  return std::visit([](const auto& c) { return finite(c); }, command);
}

}  // namespace lineservo::servo
