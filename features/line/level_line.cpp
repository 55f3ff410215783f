#include "features/line/level_line.h"

#include <Eigen/LU>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

LevelPoint level_point(const PixelPoint& px, const CameraPose& pose) {
  return pose.view.level(pose.camera.normalize(px));
}

StripeCourse course_through(const LevelPoint& begin, const LevelPoint& end) {
  const ImageLine line = line_through({begin.x, begin.y}, {end.x, end.y});
  return {.theta_rad = line.theta_rad, .rho = line.rho_px, .width = 0.0};
}

// The ends of the line moved with (ρ, θ): they stay where they are along it.
StripeCourse moved_course(const ImageLine& line, double d_rho_px, double d_theta_rad,
                          const CameraPose& pose) {
  ImageLine moved = line;
  moved.rho_px += d_rho_px;
  moved.theta_rad += d_theta_rad;
  return course_through(level_point(moved.at(line.along(line.begin)), pose),
                        level_point(moved.at(line.along(line.end)), pose));
}

double level_width(const ImageLine& line, const CameraPose& pose) {
  const double middle = 0.5 * (line.along(line.begin) + line.along(line.end));
  const PixelPoint at = line.at(middle);
  const Eigen::Vector2d half = 0.5 * line.width_px * line.normal();
  const LevelPoint low = level_point({at.x - half.x(), at.y - half.y()}, pose);
  const LevelPoint high = level_point({at.x + half.x(), at.y + half.y()}, pose);
  return std::hypot(high.x - low.x, high.y - low.y);
}

}  // namespace

// By central differences.
Eigen::Matrix2d level_jacobian(const ImageLine& line, const CameraPose& pose) {
  Eigen::Matrix2d J;
  constexpr double step[2] = {0.5, 1e-4};
  for (int k = 0; k < 2; ++k) {
    const StripeCourse high = moved_course(line, k == 0 ? step[0] : 0.0, k == 1 ? step[1] : 0.0, pose);
    const StripeCourse low = moved_course(line, k == 0 ? -step[0] : 0.0, k == 1 ? -step[1] : 0.0, pose);
    const double turn = wrap_angle(high.theta_rad - low.theta_rad);
    const bool mirrored = std::abs(turn) > kPi / 2.0;
    J(0, k) = (mirrored ? -high.rho - low.rho : high.rho - low.rho) / (2.0 * step[k]);
    J(1, k) = (mirrored ? wrap_angle(turn + kPi) : turn) / (2.0 * step[k]);
  }
  return J;
}

Eigen::Matrix2d image_covariance(const ImageLine& line, const Eigen::Matrix2d& level,
                                 const CameraPose& pose) {
  const Eigen::Matrix2d inverse = level_jacobian(line, pose).inverse();
  return inverse * level * inverse.transpose();
}

LineFeature level_line(const ImageLine& line, const CameraPose& pose) {
  LineFeature feature;
  feature.begin = level_point(line.begin, pose);
  feature.end = level_point(line.end, pose);
  const StripeCourse course = course_through(feature.begin, feature.end);
  feature.rho = course.rho;
  feature.theta_rad = course.theta_rad;
  const Eigen::Matrix2d J = level_jacobian(line, pose);
  feature.covariance = J * line.covariance * J.transpose();
  feature.width = level_width(line, pose);
  feature.quality = line.quality;
  if (course.forward().dot(feature.end.vector() - feature.begin.vector()) < 0.0)
    std::swap(feature.begin, feature.end);
  return feature;
}

}  // namespace lineservo::features
