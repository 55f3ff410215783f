#pragma once

#include <filesystem>
#include <vector>

#include "apps/onboard/tick_input.h"

namespace lineservo::apps {

/// What is known of the vehicle at an instant, for frames that come without its estimates.
struct EstimateAt {
  servo::Time t{0};
  double height_m = 0.5;
  double roll_rad = 0.0, pitch_rad = 0.0;
  Eigen::Vector3d v_H_m_s = Eigen::Vector3d::Zero();
  servo::Motion odometry;
};

/// A height that does not change, level and at rest; or what a file says.
class Estimates {
 public:
  explicit Estimates(double height_m);
  /// In order of time, at least one. Between them values are interpolated linearly. `name` is for complaints.
  Estimates(std::vector<EstimateAt> rows, std::string name);

  /// Throws InputError for an instant before the first row or after the last.
  EstimateAt at(servo::Time t) const;

 private:
  std::vector<EstimateAt> rows_;
  std::string name_;
  bool is_constant_ = false;
};

/// Reads a CSV file whose header names t_s and height_m, and any of roll_rad, pitch_rad, yaw_rad,
/// forward_m_s, left_m_s, up_m_s; other columns do not count. Times are those of the frames: seconds since
/// the first one. Velocity and yaw are integrated to the odometry. Throws InputError with the line.
Estimates read_estimates(const std::filesystem::path& file);

}  // namespace lineservo::apps
