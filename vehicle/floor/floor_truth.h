#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "vehicle/floor/layout.h"

namespace lineservo::vehicle {

/// The edge whose centreline is nearest to a point, and where on it.
struct NearestEdge {
  std::size_t edge = 0;
  CurveProjection projection;
};

/// The nearest edge of a sound layout (faults() is empty); the first of equals.
NearestEdge nearest_edge(const Layout& layout, const Eigen::Vector2d& p_W);

/// From a point to the nearest centreline of the layout.
double distance_to_centreline_m(const Layout& layout, const Eigen::Vector2d& p_W);

/// From a point to the nearest paint, 0 on it. Paint is what lies within half a width of a centreline, or in
/// a marker: at a stripe's dead end that is a half disc more than is painted.
double distance_to_paint_m(const Layout& layout, const Eigen::Vector2d& p_W);

}  // namespace lineservo::vehicle
