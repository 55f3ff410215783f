#pragma once

#include <Eigen/Core>

namespace lineservo::vehicle {

/// What somebody painted on the floor that the layout does not know of.
struct RepaintOptions {
  /// Everything painted within a circle is gone under the floor's colour; nothing at 0.
  Eigen::Vector2d cover_W = Eigen::Vector2d::Zero();
  double cover_radius_m = 0.0;  ///< 0 … 100
  /// A stripe more, in the colour and width of the first edge, from a place on; nothing at 0.
  Eigen::Vector2d branch_W = Eigen::Vector2d::Zero();
  double branch_heading_rad = 0.0;
  double branch_length_m = 0.0;  ///< 0 … 100

  /// Throws std::invalid_argument that names what is out of bounds.
  void validate() const;
};

}  // namespace lineservo::vehicle
