#pragma once

#include <filesystem>

#include "apps/watch/estimates.h"

namespace lineservo::apps {

/// Reads a CSV file whose header names t_s and height_m, and any of roll_rad, pitch_rad, yaw_rad,
/// forward_m_s, left_m_s, up_m_s; other columns do not count. Times are those of the frames: seconds since
/// the first one. Velocity and yaw are integrated to the odometry. Throws InputError with the line.
Estimates read_estimates(const std::filesystem::path& file);

}  // namespace lineservo::apps
