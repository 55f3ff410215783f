#pragma once

#include <Eigen/Core>
#include <vector>

namespace lineservo::vehicle {

/// One piece of a plane curve: a straight line (curvature 0) or a circular arc.
struct CurvePiece {
  Eigen::Vector2d start_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;      ///< direction of travel at its start
  double length_m = 0.0;         ///< > 0
  double curvature_inv_m = 0.0;  ///< positive to the left; |curvature · length| ≤ 2π
};

/// A point of a curve.
struct CurvePoint {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double curvature_inv_m = 0.0;
};

/// Where a point lies against a curve.
struct CurveProjection {
  double arc_length_m = 0.0;     ///< of the nearest point, in [0, length]
  double distance_m = 0.0;       ///< to the nearest point, ≥ 0
  double signed_offset_m = 0.0;  ///< across the curve at the nearest point, positive to the left of travel
};

/// A plane curve made of lines and arcs, by arc length. Immutable.
class Curve {
 public:
  Curve() = default;
  static Curve line(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W);
  /// Throws std::invalid_argument for fewer than two points or two equal ones in a row.
  static Curve polyline(const std::vector<Eigen::Vector2d>& points_W);
  /// The circular arc from one point to another about a centre, counter-clockwise or clockwise; equal end
  /// points give a full circle. Throws std::invalid_argument when the radii differ by more than 1 mm or are
  /// zero.
  static Curve arc(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W,
                   const Eigen::Vector2d& centre_W, bool counter_clockwise);

  const std::vector<CurvePiece>& pieces() const { return pieces_; }
  double length_m() const { return length_m_; }
  /// Each piece as a curve of its own.
  std::vector<Curve> parts() const;
  /// The point at an arc length, clamped to the curve.
  CurvePoint at(double arc_length_m) const;
  /// A polyline to draw it by: the ends of its pieces, and of arcs points that are no farther apart than this
  /// angle.
  std::vector<Eigen::Vector2d> outline(double arc_step_rad = 0.05) const;
  CurveProjection project(const Eigen::Vector2d& p_W) const;

 private:
  explicit Curve(std::vector<CurvePiece> pieces);

  std::vector<CurvePiece> pieces_;
  double length_m_ = 0.0;
};

}  // namespace lineservo::vehicle
