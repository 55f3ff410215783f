#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "features/frame_features.h"

namespace lineservo::servo {

/// A planar displacement: from one pose of the heading frame to another, written in the first.
struct Motion {
  Eigen::Vector2d translation_m = Eigen::Vector2d::Zero();  ///< forward, left
  double yaw_rad = 0.0;
};

/// One motion after the other.
Motion compose(const Motion& first, const Motion& second);
/// The motion that leads from one dead-reckoned pose to another, both written in the same origin.
Motion between(const Motion& from, const Motion& to);

/// A floor point seen in the level camera, in metres of the heading frame (forward, left) from below the
/// vehicle.
inline Eigen::Vector2d floor_point_m(const features::LevelPoint& p, double height_m) {
  return {-p.y * height_m, -p.x * height_m};
}
/// The inverse of floor_point_m().
inline features::LevelPoint level_point(const Eigen::Vector2d& p_H_m, double height_m) {
  return {-p_H_m.y() / height_m, -p_H_m.x() / height_m};
}

/// A floor point (heading frame, metres) as it lies after the vehicle has moved.
inline Eigen::Vector2d after(const Motion& motion, const Eigen::Vector2d& p_H_m) {
  return Eigen::Rotation2Dd(-motion.yaw_rad) * (p_H_m - motion.translation_m);
}

/// (ρ, θ) of a line as they are after the vehicle has moved at this height, on the branch nearest to the old
/// θ.
features::LineFeature after(const Motion& motion, features::LineFeature line, double height_m);

}  // namespace lineservo::servo
