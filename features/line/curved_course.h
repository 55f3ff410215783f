#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "features/line/stripe.h"

namespace lineservo::features {

/// The course of a stripe that may bend and, seen at an unknown tilt, widen: its centreline runs through
/// `foot` in the direction forward(), with constant curvature. A plane curve in the level camera or, when
/// nothing is known of the camera, in the image.
struct CurvedCourse {
  Eigen::Vector2d foot = Eigen::Vector2d::Zero();
  double theta_rad = 0.0;  ///< of the normal at the foot
  double width = 0.0;      ///< at the foot
  double curvature = 0.0;  ///< positive: bends towards the normal
  double taper = 0.0;      ///< change of the width per length

  static CurvedCourse straight(const StripeCourse& course, double along) {
    return {.foot = StripeAxes(course).at(along, 0.0), .theta_rad = course.theta_rad, .width = course.width};
  }

  Eigen::Vector2d normal() const { return {std::cos(theta_rad), std::sin(theta_rad)}; }
  Eigen::Vector2d forward() const { return {std::sin(theta_rad), -std::cos(theta_rad)}; }
  double width_at(double along) const { return width + taper * along; }
  /// The point at an arc length from the foot and a distance from the centreline.
  Eigen::Vector2d at(double along, double across) const;
  /// The tangent's normal there.
  double theta_at(double along) const { return theta_rad + curvature * along; }
  /// Arc length (to second order in the curvature) of the point of the centreline nearest to p.
  double along(const Eigen::Vector2d& p) const;
  /// Signed distance from the centreline, towards the normal.
  double across(const Eigen::Vector2d& p) const;
};

}  // namespace lineservo::features
