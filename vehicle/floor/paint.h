#pragma once

#include <Eigen/Core>
#include <vector>

#include "vehicle/floor/layout.h"

namespace lineservo::vehicle {

/// A border of paint on the floor, in W: a straight line or a circle.
struct PaintBorder {
  enum class Kind {
    straight,        ///< painted where n·p ≤ offset
    inside_circle,   ///< painted where |p − centre| ≤ radius
    outside_circle,  ///< painted where |p − centre| ≥ radius
  };
  Kind kind = Kind::straight;
  Eigen::Vector2d n_W = Eigen::Vector2d::UnitX();
  double offset_m = 0.0;
  Eigen::Vector2d centre_W = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  int id = 0;  ///< borders that coincide have the same id

  bool paints(const Eigen::Vector2d& p_W) const;
};

/// What lies within all of its borders is painted.
struct PaintShape {
  Bgr colour = {};
  std::vector<PaintBorder> borders;

  bool paints(const Eigen::Vector2d& p_W) const;
};

/// At most four borders make a shape: two sides and two ends.
inline constexpr int kMaxBorders = 4;

/// The painted shapes of a layout, later ones on top of earlier ones: joints, stripes in the order of the
/// edges, start markers, end markers.
std::vector<PaintShape> paint_of(const Layout& layout);

}  // namespace lineservo::vehicle
