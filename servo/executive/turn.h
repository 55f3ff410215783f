#pragma once

#include <optional>

#include "servo/law/observation.h"

namespace lineservo::servo {

/// A turn from one edge to the next. The gyro leads it; as soon as a line is seen near the heading where the
/// next edge should be, that line's angle decides where the turn ends. Headings are of the dead reckoning.
class Turn {
 public:
  Turn() = default;
  Turn(double heading_in_rad, double turn_rad)
      : heading_in_rad_(heading_in_rad), heading_out_rad_(heading_in_rad + turn_rad) {}

  double heading_in_rad() const { return heading_in_rad_; }
  double heading_out_rad() const { return heading_out_rad_; }
  /// What is left to turn now, positive to the left.
  double left_rad(const Observation& observation) const {
    return heading_out_rad_ - observation.estimate.odometry_now.yaw_rad;
  }

  /// Looks for the next edge's line and, when the frame shows it, takes its heading. The line's angle now.
  std::optional<double> correct(const Observation& observation);

 private:
  double heading_in_rad_ = 0.0;
  double heading_out_rad_ = 0.0;
};

}  // namespace lineservo::servo
