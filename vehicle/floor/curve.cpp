#include "vehicle/floor/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "features/geometry/angles.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;
using features::kPi;

Vector2d direction(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

Vector2d left_of(const Vector2d& d) {
  return {-d.y(), d.x()};
}

Vector2d centre_of(const CurvePiece& piece) {
  return piece.start_W + left_of(direction(piece.heading_rad)) / piece.curvature_inv_m;
}

// p(s) = start + s u for a line; on an arc the chord of the angle φ = κ s has length 2 sin(φ/2)/κ and heading
// ψ + φ/2.
CurvePoint point_on(const CurvePiece& piece, double s_m) {
  const double turned_rad = piece.curvature_inv_m * s_m;
  const double chord_m =
      piece.curvature_inv_m == 0.0 ? s_m : 2.0 * std::sin(0.5 * turned_rad) / piece.curvature_inv_m;
  return {piece.start_W + chord_m * direction(piece.heading_rad + 0.5 * turned_rad),
          features::wrap_angle(piece.heading_rad + turned_rad), piece.curvature_inv_m};
}

double nearest_on_line(const CurvePiece& piece, const Vector2d& p_W) {
  const double along_m = direction(piece.heading_rad).dot(p_W - piece.start_W);
  return std::clamp(along_m, 0.0, piece.length_m);
}

// The angle about the centre from the start to the point, in the sense of travel, gives the arc length; past
// the end the nearer end counts.
double nearest_on_arc(const CurvePiece& piece, const Vector2d& p_W) {
  const Vector2d centre_W = centre_of(piece);
  const Vector2d from = piece.start_W - centre_W, to = p_W - centre_W;
  const double sense = piece.curvature_inv_m > 0.0 ? 1.0 : -1.0;
  double angle_rad = sense * std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  if (angle_rad < 0.0) angle_rad += 2.0 * kPi;
  const double s_m = angle_rad / std::abs(piece.curvature_inv_m);
  if (s_m <= piece.length_m) return s_m;
  const Vector2d end_W = point_on(piece, piece.length_m).p_W;
  return (p_W - piece.start_W).squaredNorm() <= (p_W - end_W).squaredNorm() ? 0.0 : piece.length_m;
}

CurveProjection project_on(const CurvePiece& piece, const Vector2d& p_W) {
  const double s_m = piece.curvature_inv_m == 0.0 ? nearest_on_line(piece, p_W) : nearest_on_arc(piece, p_W);
  const CurvePoint nearest = point_on(piece, s_m);
  const Vector2d offset_W = p_W - nearest.p_W;
  return {s_m, offset_W.norm(), left_of(direction(nearest.heading_rad)).dot(offset_W)};
}

CurvePiece straight_piece(const Vector2d& from_W, const Vector2d& to_W) {
  const Vector2d d = to_W - from_W;
  if (!(d.norm() > 0.0)) throw std::invalid_argument("curve: two equal points in a row");
  return {from_W, std::atan2(d.y(), d.x()), d.norm(), 0.0};
}

}  // namespace

Curve::Curve(std::vector<CurvePiece> pieces) : pieces_(std::move(pieces)) {
  for (const CurvePiece& piece : pieces_) length_m_ += piece.length_m;
}

Curve Curve::line(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W) {
  return Curve({straight_piece(from_W, to_W)});
}

Curve Curve::polyline(const std::vector<Eigen::Vector2d>& points_W) {
  if (points_W.size() < 2) throw std::invalid_argument("curve: a polyline needs at least two points");
  std::vector<CurvePiece> pieces;
  for (std::size_t i = 1; i < points_W.size(); ++i)
    pieces.push_back(straight_piece(points_W[i - 1], points_W[i]));
  return Curve(std::move(pieces));
}

Curve Curve::arc(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W, const Eigen::Vector2d& centre_W,
                 bool counter_clockwise) {
  const Vector2d from = from_W - centre_W, to = to_W - centre_W;
  const double radius_m = from.norm();
  if (!(radius_m > 0.0) || !(std::abs(radius_m - to.norm()) <= 1e-3))
    throw std::invalid_argument(
        "curve: an arc's ends must lie at the same, positive distance from its centre");
  const double sense = counter_clockwise ? 1.0 : -1.0;
  double sweep_rad = sense * std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  if (from_W == to_W) sweep_rad = 2.0 * kPi;
  if (sweep_rad <= 0.0) sweep_rad += 2.0 * kPi;
  const Vector2d forward = sense * left_of(from / radius_m);
  return Curve({{from_W, std::atan2(forward.y(), forward.x()), sweep_rad * radius_m, sense / radius_m}});
}

std::vector<Curve> Curve::parts() const {
  std::vector<Curve> parts;
  for (const CurvePiece& piece : pieces_) parts.push_back(Curve({piece}));
  return parts;
}

std::vector<Eigen::Vector2d> Curve::outline(double arc_step_rad) const {
  std::vector<Eigen::Vector2d> points;
  double begin_m = 0.0;
  for (const CurvePiece& piece : pieces_) {
    const double bend_rad = std::abs(piece.curvature_inv_m) * piece.length_m;
    const int steps = std::max(1, static_cast<int>(std::ceil(bend_rad / arc_step_rad)));
    for (int k = 0; k < steps; ++k) points.push_back(at(begin_m + piece.length_m * k / steps).p_W);
    begin_m += piece.length_m;
  }
  if (!pieces_.empty()) points.push_back(at(length_m_).p_W);
  return points;
}

CurvePoint Curve::at(double arc_length_m) const {
  if (pieces_.empty()) return {};
  double s_m = std::clamp(arc_length_m, 0.0, length_m_);
  std::size_t i = 0;
  for (; i + 1 < pieces_.size() && s_m > pieces_[i].length_m; ++i) s_m -= pieces_[i].length_m;
  return point_on(pieces_[i], std::min(s_m, pieces_[i].length_m));
}

CurveProjection Curve::project(const Eigen::Vector2d& p_W) const {
  if (pieces_.empty()) return {0.0, p_W.norm(), p_W.y()};
  CurveProjection best = project_on(pieces_.front(), p_W);
  double before_m = pieces_.front().length_m;
  for (std::size_t i = 1; i < pieces_.size(); ++i) {
    CurveProjection candidate = project_on(pieces_[i], p_W);
    candidate.arc_length_m += before_m;
    if (candidate.distance_m < best.distance_m) best = candidate;
    before_m += pieces_[i].length_m;
  }
  return best;
}

}  // namespace lineservo::vehicle
