#include "apps/output/command_row.h"

#include <limits>

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

CommandRow row(const servo::VelocityCommand& c) {
  return {c.forward_m_s, c.left_m_s, c.up_m_s, c.yaw_rate_rad_s, kNaN, kNaN, kNaN};
}
CommandRow row(const servo::AttitudeCommand& c) {
  return {kNaN, kNaN, kNaN, c.yaw_rate_rad_s, c.roll_rad, c.pitch_rad, c.height_m};
}
CommandRow row(const servo::LandCommand&) {
  return {kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
}

}  // namespace

CommandRow row_of(const servo::Command& command) {
  return std::visit([](const auto& c) { return row(c); }, command);
}

}  // namespace lineservo::apps
