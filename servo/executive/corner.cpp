#include "servo/executive/corner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace lineservo::servo {
namespace {

Eigen::Vector2d along(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

double signed_angle_rad(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

}  // namespace

CornerArc corner_arc(double turn_rad, double speed_m_s, const CornerOptions& options) {
  const double leaves = 1.0 - std::cos(0.5 * turn_rad);  // of the radius
  const double a = options.acceleration_m_s2;
  const double radius_m = std::min(speed_m_s * speed_m_s / a, options.deviation_m / leaves);
  return {radius_m, std::sqrt(a * radius_m)};
}

CornerArc shortened(const CornerArc& arc, double turn_rad, double ahead_m, const CornerOptions& options) {
  const double room_m = std::max(0.0, ahead_m) / std::tan(0.5 * std::abs(turn_rad));
  if (arc.radius_m <= room_m) return arc;
  return {room_m, std::sqrt(options.acceleration_m_s2 * room_m)};
}

CornerPath::CornerPath(const Eigen::Vector2d& node_m, double heading_in_rad, double turn_rad, double radius_m)
    : heading_in_rad_(heading_in_rad),
      turn_rad_(turn_rad),
      radius_m_(radius_m),
      half_arc_m_(0.5 * radius_m * std::abs(turn_rad)),
      along_in_(along(heading_in_rad)),
      along_out_(along(heading_in_rad + turn_rad)) {
  const double tangent_m = radius_m * std::tan(0.5 * std::abs(turn_rad));
  arc_begin_m_ = node_m - tangent_m * along_in_;
  arc_end_point_m_ = node_m + tangent_m * along_out_;
  const Eigen::Vector2d left = along(heading_in_rad + 0.5 * features::kPi);
  centre_m_ = arc_begin_m_ + std::copysign(radius_m, turn_rad) * left;
}

double CornerPath::nearest_way_m(const Eigen::Vector2d& p_m) const {
  const double before_m = std::min(0.0, (p_m - arc_begin_m_).dot(along_in_));
  const double beyond_m = std::max(0.0, (p_m - arc_end_point_m_).dot(along_out_));
  const double ways_m[] = {before_m - half_arc_m_, nearest_on_arc_m(p_m), beyond_m + half_arc_m_};
  return *std::min_element(std::begin(ways_m), std::end(ways_m), [&](double a, double b) {
    return (point_m(a) - p_m).squaredNorm() < (point_m(b) - p_m).squaredNorm();
  });
}

double CornerPath::nearest_on_arc_m(const Eigen::Vector2d& p_m) const {
  const double turned_rad =
      std::copysign(1.0, turn_rad_) * signed_angle_rad(arc_begin_m_ - centre_m_, p_m - centre_m_);
  return std::clamp(turned_rad, 0.0, std::abs(turn_rad_)) * radius_m_ - half_arc_m_;
}

Eigen::Vector2d CornerPath::point_m(double way_m) const {
  if (way_m <= -half_arc_m_) return arc_begin_m_ + (way_m + half_arc_m_) * along_in_;
  if (way_m >= half_arc_m_) return arc_end_point_m_ + (way_m - half_arc_m_) * along_out_;
  const Eigen::Rotation2Dd turned(heading_rad(way_m) - heading_in_rad_);
  return centre_m_ + turned * (arc_begin_m_ - centre_m_);
}

double CornerPath::heading_rad(double way_m) const {
  if (way_m <= -half_arc_m_) return heading_in_rad_;
  if (way_m >= half_arc_m_) return heading_in_rad_ + turn_rad_;
  return heading_in_rad_ + 0.5 * turn_rad_ * (1.0 + way_m / half_arc_m_);
}

}  // namespace lineservo::servo
