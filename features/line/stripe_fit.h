#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "features/line/border_points.h"
#include "features/line/stripe.h"

namespace lineservo::features {

/// How a stripe was fitted to its borders.
struct StripeFit {
  StripeCourse course;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of (ρ, θ)
  double rising_length = 0.0;   ///< of border that supports the stripe where the paint begins along +ρ
  double falling_length = 0.0;  ///< and where it stops
  double scatter = 0.0;         ///< of the border points about the fitted borders, one σ
};

/// The same course with θ in (−π/2, π/2].
StripeCourse canonical(StripeCourse course);

enum class WidthIs { free, known };

/// Fits one direction, offset and (unless it is known) width to both borders of a stripe at once, by
/// iteratively reweighted least squares with Tukey's weights. None if too little border supports it.
std::optional<StripeFit> fit_stripe(std::span<const BorderPoint> points, const StripeCourse& start,
                                    WidthIs width);

/// The signed distance of a point from the stripe's border of the point's own kind.
inline double border_residual(const BorderPoint& point, const StripeCourse& course,
                              const Eigen::Vector2d& normal) {
  const double side = point.normal.dot(normal) > 0.0 ? 0.5 : -0.5;
  return point.p_L.dot(normal) - course.rho + side * course.width;
}

}  // namespace lineservo::features
