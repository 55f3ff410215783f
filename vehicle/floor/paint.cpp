#include "vehicle/floor/paint.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"
#include "vehicle/floor/stripes.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using Kind = PaintBorder::Kind;

PaintBorder straight_border(const Vector2d& n_W, double offset_m) {
  PaintBorder border;
  border.n_W = n_W;
  border.offset_m = offset_m;
  return border;
}

PaintBorder round_border(Kind kind, const Vector2d& centre_W, double radius_m) {
  PaintBorder border;
  border.kind = kind;
  border.centre_W = centre_W;
  border.radius_m = radius_m;
  return border;
}

PaintShape disc(const Vector2d& p_W, double radius_m, const Bgr& colour) {
  return {colour, {round_border(Kind::inside_circle, p_W, radius_m)}};
}

void add_ends(const Stripe& stripe, const Vector2d& forward_W, const Vector2d& end_forward_W,
              const Vector2d& end_W, PaintShape& shape) {
  shape.borders.push_back(
      straight_border(-forward_W, stripe.before_m - forward_W.dot(stripe.centreline.start_W)));
  shape.borders.push_back(straight_border(end_forward_W, stripe.after_m + end_forward_W.dot(end_W)));
}

PaintShape straight_stripe(const Stripe& stripe) {
  const CurvePiece& line = stripe.centreline;
  const Vector2d u(std::cos(line.heading_rad), std::sin(line.heading_rad));
  const Vector2d left(-u.y(), u.x());
  const double across_m = left.dot(line.start_W), half_m = 0.5 * stripe.width_m;
  PaintShape shape{stripe.colour,
                   {straight_border(left, half_m + across_m), straight_border(-left, half_m - across_m)}};
  add_ends(stripe, u, u, line.start_W + line.length_m * u, shape);
  return shape;
}

// A ring sector; a whole turn has no ends.
PaintShape round_stripe(const Stripe& stripe) {
  const CurvePiece& arc = stripe.centreline;
  const double turn_rad = arc.curvature_inv_m * arc.length_m, radius_m = 1.0 / std::abs(arc.curvature_inv_m);
  const Vector2d u(std::cos(arc.heading_rad), std::sin(arc.heading_rad));
  const Vector2d to_centre = Vector2d(-u.y(), u.x()) / arc.curvature_inv_m;
  const Vector2d centre_W = arc.start_W + to_centre;
  const double half_m = 0.5 * stripe.width_m;
  PaintShape shape{stripe.colour, {round_border(Kind::inside_circle, centre_W, radius_m + half_m)}};
  if (radius_m > half_m)
    shape.borders.push_back(round_border(Kind::outside_circle, centre_W, radius_m - half_m));
  if (std::abs(turn_rad) >= 2.0 * features::kPi - 1e-9) return shape;
  Eigen::Matrix2d turn;
  turn << std::cos(turn_rad), -std::sin(turn_rad), std::sin(turn_rad), std::cos(turn_rad);
  add_ends(stripe, u, turn * u, centre_W - turn * to_centre, shape);
  return shape;
}

bool coincide(const PaintBorder& a, const PaintBorder& b) {
  constexpr double kAngle_rad = 1e-9, kLength_m = 1e-7;
  if (a.kind != b.kind) return false;
  if (a.kind == Kind::straight)
    return (a.n_W - b.n_W).norm() < kAngle_rad && std::abs(a.offset_m - b.offset_m) < kLength_m;
  return (a.centre_W - b.centre_W).norm() < kLength_m && std::abs(a.radius_m - b.radius_m) < kLength_m;
}

void number_borders(std::vector<PaintShape>& shapes) {
  std::vector<PaintBorder> distinct;
  for (PaintShape& shape : shapes)
    for (PaintBorder& border : shape.borders) {
      const auto same = std::find_if(distinct.begin(), distinct.end(),
                                     [&](const PaintBorder& other) { return coincide(border, other); });
      border.id = static_cast<int>(same - distinct.begin());
      if (same == distinct.end()) distinct.push_back(border);
    }
}

}  // namespace

bool PaintBorder::paints(const Vector2d& p_W) const {
  if (kind == Kind::straight) return n_W.dot(p_W) <= offset_m;
  const double r_m = (p_W - centre_W).norm();
  return kind == Kind::inside_circle ? r_m <= radius_m : r_m >= radius_m;
}

bool PaintShape::paints(const Vector2d& p_W) const {
  return std::all_of(borders.begin(), borders.end(), [&](const PaintBorder& b) { return b.paints(p_W); });
}

std::vector<PaintShape> paint_of(const Layout& layout) {
  std::vector<PaintShape> shapes;
  const Stripes stripes = stripes_of(layout);
  for (const JointDisc& joint : stripes.joints)
    shapes.push_back(disc(joint.p_W, joint.radius_m, joint.colour));
  for (const Stripe& stripe : stripes.pieces)
    shapes.push_back(stripe.centreline.curvature_inv_m == 0.0 ? straight_stripe(stripe)
                                                              : round_stripe(stripe));
  for (const auto* markers : {&layout.start_markers, &layout.end_markers})
    for (const LayoutMarker& marker : *markers)
      shapes.push_back(disc(marker.p_W, marker.radius_m, marker.colour));
  number_borders(shapes);
  return shapes;
}

}  // namespace lineservo::vehicle
