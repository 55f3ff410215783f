#include "features/line/course_view.h"

#include <algorithm>

#include "features/geometry/angles.h"
#include "features/line/level_line.h"

namespace lineservo::features {
namespace {

// Rounding to pixels and what else a fit does not know of: not even a perfect picture gives more.
constexpr double kFloor_px = 0.02;

double nearest_to_centre(const CurvedCourse& course, const CourseStretch& stretch, const CameraPose& pose) {
  const PixelPoint centre{0.5 * (pose.camera.width_px() - 1), 0.5 * (pose.camera.height_px() - 1)};
  const LevelPoint p = pose.view.level(pose.camera.normalize(centre));
  return std::clamp(course.along(p.vector()), stretch.from, stretch.to);
}

// ρ = foot·n + offset, so dρ = d(offset) + foot·n' dθ with n' = −forward; floors are those of a straight
// stripe half as long as the image is wide. The mirrored branch turns the sign of ρ.
Eigen::Matrix2d covariance_about_origin(const CurvedFit& fit, bool mirrored, double floor) {
  Eigen::Matrix2d J;
  J << 1.0, -fit.course.foot.dot(fit.course.forward()), 0.0, 1.0;
  if (mirrored) J.row(0) = -J.row(0);
  Eigen::Matrix2d C = J * fit.covariance * J.transpose();
  C(0, 0) += floor * floor;
  C(1, 1) += floor * floor;
  return C;
}

ImageLine image_tangent(const CurvedCourse& course, const CourseStretch& stretch, double along,
                        const CameraPose& pose) {
  const double step = 0.5 / pose.camera.parameters().fx_px;
  ImageLine line =
      line_through(project(pose, course.at(along - step, 0.0)), project(pose, course.at(along + step, 0.0)));
  const double half = 0.5 * course.width_at(along);
  const PixelPoint low = project(pose, course.at(along, -half)), high = project(pose, course.at(along, half));
  line.width_px = std::abs(line.across(high) - line.across(low));
  line.begin = project(pose, course.at(stretch.from, 0.0));
  line.end = project(pose, course.at(stretch.to, 0.0));
  if (line.along(line.begin) > line.along(line.end)) std::swap(line.begin, line.end);
  return line;
}

}  // namespace

PixelPoint project(const CameraPose& pose, const Eigen::Vector2d& p_L) {
  return pose.camera.project(pose.view.tilted({p_L.x(), p_L.y()}));
}

LineFeature level_tangent(const CurvedFit& fit, const CourseStretch& stretch, double along, double quality,
                          double floor) {
  const CurvedCourse& course = fit.course;
  const Eigen::Vector2d p = course.at(along, 0.0);
  const double theta_rad = course.theta_at(along);
  const ImageLine line = canonical_line(p.x() * std::cos(theta_rad) + p.y() * std::sin(theta_rad), theta_rad);
  LineFeature feature;
  feature.rho = line.rho_px;
  feature.theta_rad = line.theta_rad;
  feature.width = course.width_at(along);
  feature.quality = quality;
  const Eigen::Vector2d begin = course.at(stretch.from, 0.0), end = course.at(stretch.to, 0.0);
  feature.begin = {begin.x(), begin.y()};
  feature.end = {end.x(), end.y()};
  if (line.forward().dot(end - begin) < 0.0) std::swap(feature.begin, feature.end);
  const bool mirrored = std::cos(line.theta_rad - theta_rad) < 0.0;
  feature.curvature = mirrored ? -course.curvature : course.curvature;
  feature.covariance = covariance_about_origin(fit, mirrored, floor);
  return feature;
}

DetectedLine view_course(const CurvedFit& fit, const CourseStretch& stretch, const CameraPose& pose,
                         double quality) {
  const CurvedCourse& course = fit.course;
  const double along = nearest_to_centre(course, stretch, pose);
  const LineFeature level =
      level_tangent(fit, stretch, along, quality, kFloor_px / pose.camera.parameters().fx_px);
  ImageLine image = image_tangent(course, stretch, along, pose);
  image.quality = quality;
  image.covariance = image_covariance(image, level.covariance, pose);
  const bool image_mirrored = std::cos(image.theta_rad - course.theta_rad) < 0.0;
  image.curvature_inv_px = (image_mirrored ? -course.curvature : course.curvature) * course.width_at(along) /
                           std::max(image.width_px, 1e-9);
  return {image, level};
}

}  // namespace lineservo::features
