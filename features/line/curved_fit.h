#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "features/line/curved_course.h"

namespace lineservo::features {

/// A point on one border of a stripe.
struct EdgePoint {
  Eigen::Vector2d p;
  double side = 1.0;  ///< +1: the border on the side of the normal, −1: the other one
};

/// What a fit may change besides direction and offset.
struct FreeShape {
  bool width = true;
  bool curvature = false;
  bool taper = false;
};

/// A course with borders that may bend and converge, and how sure its parameters are.
struct CurvedFit {
  CurvedCourse course;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of (offset at the foot, θ)
  double curvature_sigma = 0.0;                              ///< 0: was not free
  double taper_sigma = 0.0;
  double scatter = 0.0;  ///< of the points about the borders, one σ
  int supporters = 0;    ///< points with weight
};

/// Fits both borders of a stripe at once, concentric where they bend, by iteratively reweighted least squares
/// with Tukey's weights; their cut-off comes from the median residual and lies within [least_reach, reach].
/// None if fewer than eight points support it.
std::optional<CurvedFit> fit_borders(const std::vector<EdgePoint>& points, const CurvedCourse& start,
                                     const FreeShape& shape, double reach, double least_reach);

}  // namespace lineservo::features
