#include "vehicle/floor/image_border.h"

#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {
namespace {

using Eigen::RowVector3d;
using Eigen::Vector2d;

constexpr double kLowest_m = 1e-3;
constexpr double kSmallestFall = 0.01;

LinearForm linear_form(const RowVector3d& row) {
  return {static_cast<float>(row.x()), static_cast<float>(row.y()), static_cast<float>(row.z())};
}

// |∂F/∂x| ≤ √(l₁ₓ² + l₂ₓ²) + |l₀ₓ|: the gradient of a norm is no longer than that of its argument.
ImageBorder bounded(ImageBorder border) {
  border.bound_x = std::sqrt(border.l1.x * border.l1.x + border.l2.x * border.l2.x) + std::abs(border.l0.x);
  border.bound_y = std::sqrt(border.l1.y * border.l1.y + border.l2.y * border.l2.y) + std::abs(border.l0.y);
  return border;
}

float value_at(const ImageBorder& border, float x, float y) {
  const float l0 = border.l0.at(x, y);
  if (!border.is_round) return l0;
  const float l1 = border.l1.at(x, y), l2 = border.l2.at(x, y);
  return border.sign * (std::sqrt(l1 * l1 + l2 * l2) + l0);
}

}  // namespace

Side side_of(const ImageBorder& border, const RayRect& rect) {
  const float value = value_at(border, rect.x, rect.y);
  const float reach = border.bound_x * rect.half_x + border.bound_y * rect.half_y;
  if (value >= reach) return Side::bare;
  return value <= -reach ? Side::painted : Side::crossed;
}

FloorView::FloorView(const Eigen::Isometry3d& X_WC)
    : R_WC_(X_WC.linear()),
      foot_W_(X_WC.translation().head<2>()),
      height_m_(std::max(X_WC.translation().z(), kLowest_m)) {}

// The ray r = (x, y, 1) meets the floor at p = foot + h (R r)_xy / D with its fall D = −(R r)_z, so that
//   (n·p − c) D = h n·(R r)_xy − (c − n·foot) D,
// which is linear in (x, y) and keeps its sign where D > 0. Distances are taken from the foot so that single
// precision does.
LinearForm FloorView::straight(const Vector2d& n_W, double offset_m) const {
  const double c_m = offset_m - n_W.dot(foot_W_);
  return linear_form(height_m_ * n_W.transpose() * R_WC_.topRows<2>() + c_m * R_WC_.row(2));
}

// A circle: (|p − m| − r) D = |h (R r)_xy − (m − foot) D| − r D.
ImageBorder FloorView::project(const PaintBorder& border) const {
  ImageBorder image;
  image.id = border.id;
  if (border.kind == PaintBorder::Kind::straight) {
    image.l0 = straight(border.n_W, border.offset_m);
    return bounded(image);
  }
  image.is_round = true;
  image.sign = border.kind == PaintBorder::Kind::inside_circle ? 1.0F : -1.0F;
  image.l0 = linear_form(border.radius_m * R_WC_.row(2));
  image.l1 = straight(Vector2d::UnitX(), border.centre_W.x());
  image.l2 = straight(Vector2d::UnitY(), border.centre_W.y());
  return bounded(image);
}

ImageBorder FloorView::horizon() const {
  ImageBorder image;
  image.id = -1;
  image.l0 = linear_form(-R_WC_.row(2) - RowVector3d(0.0, 0.0, kSmallestFall));
  return bounded(image);
}

}  // namespace lineservo::vehicle
