#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "features/frame_features.h"
#include "features/geometry/angles.h"
#include "servo/task/command.h"

namespace lineservo::servo::testing {

/// Where the heading frame H of a level vehicle is: p_WH and heading on the floor, height above it.
struct Pose {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double height_m = 0.5;
};

/// A floor point in H: metres forward and left of the point below the vehicle.
inline Eigen::Vector2d in_heading_frame(const Pose& pose, const Eigen::Vector2d& point_W) {
  return Eigen::Rotation2Dd(-pose.heading_rad) * (point_W - pose.p_W);
}

/// A floor point in the level camera, from the axes of conventions.md alone: x_C = −y_H, y_C = −x_H, at depth
/// h.
inline features::LevelPoint seen_point(const Pose& pose, const Eigen::Vector2d& point_W) {
  const Eigen::Vector2d p_H = in_heading_frame(pose, point_W);
  return {-p_H.y() / pose.height_m, -p_H.x() / pose.height_m};
}

/// (ρ, θ) of the straight line through two image points: θ is the angle of a normal, in (−π/2, π/2].
inline features::LineFeature line_through(const features::LevelPoint& a, const features::LevelPoint& b) {
  features::LineFeature line;
  const Eigen::Vector2d along = b.vector() - a.vector();
  line.theta_rad = std::atan2(-along.x(), along.y());
  if (line.theta_rad > features::kPi / 2) line.theta_rad -= features::kPi;
  if (line.theta_rad <= -features::kPi / 2) line.theta_rad += features::kPi;
  line.rho = a.x * std::cos(line.theta_rad) + a.y * std::sin(line.theta_rad);
  line.begin = a.y > b.y ? a : b;  // y is backward: the end is what lies further forward
  line.end = a.y > b.y ? b : a;
  line.quality = 1.0;
  return line;
}

/// The floor line through two floor points as the level camera sees it.
inline features::LineFeature seen_line(const Pose& pose, const Eigen::Vector2d& a_W,
                                       const Eigen::Vector2d& b_W) {
  return line_through(seen_point(pose, a_W), seen_point(pose, b_W));
}

/// The pose after a constant velocity in H for dt, exactly: with Δ = ω·dt the chord of the arc is
/// R(ψ + Δ/2) v dt · sin(Δ/2) / (Δ/2).
inline Pose moved(const Pose& from, const VelocityCommand& velocity, double dt_s) {
  const double half_turn_rad = 0.5 * velocity.yaw_rate_rad_s * dt_s;
  const double chord = std::abs(half_turn_rad) < 1e-9 ? 1.0 : std::sin(half_turn_rad) / half_turn_rad;
  Pose to = from;
  to.p_W += Eigen::Rotation2Dd(from.heading_rad + half_turn_rad) *
            Eigen::Vector2d(velocity.forward_m_s, velocity.left_m_s) * (dt_s * chord);
  to.heading_rad += 2.0 * half_turn_rad;
  to.height_m += velocity.up_m_s * dt_s;
  return to;
}

}  // namespace lineservo::servo::testing
