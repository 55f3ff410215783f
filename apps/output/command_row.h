#pragma once

#include <array>

#include "servo/task/command.h"

namespace lineservo::apps {

/// A command as the columns of a table; what its kind does not set is not a number.
using CommandRow = std::array<double, 7>;

/// The columns' names, in their order.
inline constexpr std::array<const char*, 7> kCommandColumns = {
    "forward_m_s", "left_m_s", "up_m_s", "yaw_rate_rad_s", "roll_rad", "pitch_rad", "height_m"};

CommandRow row_of(const servo::Command& command);

}  // namespace lineservo::apps
