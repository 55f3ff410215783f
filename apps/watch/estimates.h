#pragma once

#include <string>
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

}  // namespace lineservo::apps
