#pragma once

#include <Eigen/Geometry>

#include "vehicle/floor/paint.h"
#include "vehicle/floor/tile_grid.h"

namespace lineservo::vehicle {

/// a x + b y + c on the normalised image plane.
struct LinearForm {
  float x = 0.0F, y = 0.0F, one = 0.0F;

  float at(float ray_x, float ray_y) const { return x * ray_x + y * ray_y + one; }
};

/// A border of paint as the camera sees it: the function
///   F(x, y) = s (√(l₁² + l₂²) + l₀),   l₀, l₁, l₂ linear,
/// is negative on the painted side and zero on the border. A straight border has l₁ = l₂ = 0, s = 1.
struct ImageBorder {
  LinearForm l0, l1, l2;
  float sign = 1.0F;
  bool is_round = false;
  int id = 0;                            ///< borders that coincide have the same id
  float bound_x = 0.0F, bound_y = 0.0F;  ///< |∂F/∂x| and |∂F/∂y| nowhere exceed these
};

/// Where a border lies as seen from a rectangle of rays.
enum class Side { painted, bare, crossed };
Side side_of(const ImageBorder& border, const RayRect& rect);

/// The floor as seen by a camera at one instant: maps floor geometry to the normalised image plane.
class FloorView {
 public:
  /// The camera must be above the floor; one that is lower than 1 mm is taken to be at 1 mm.
  explicit FloorView(const Eigen::Isometry3d& X_WC);

  ImageBorder project(const PaintBorder& border) const;
  /// The horizon, with the sky on its painted side. Floor further off than 100 heights is sky as well.
  ImageBorder horizon() const;

 private:
  LinearForm straight(const Eigen::Vector2d& n_W, double offset_m) const;

  Eigen::Matrix3d R_WC_;
  Eigen::Vector2d foot_W_;
  double height_m_;
};

}  // namespace lineservo::vehicle
