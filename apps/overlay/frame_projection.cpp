#include "apps/overlay/frame_projection.h"

#include <algorithm>
#include <cmath>

namespace lineservo::apps {
namespace {

constexpr double kBeyondCorners = 1.1;  // what a lens model that holds at the corners is good for
constexpr double kFarPinhole = 20.0;

double farthest(const features::CameraModel& camera) {
  if (!camera.has_distortion()) return kFarPinhole;
  double corner = 0.0;
  for (const double x : {-0.5, camera.width_px() - 0.5}) {
    for (const double y : {-0.5, camera.height_px() - 0.5}) {
      const features::NormalizedPoint p = camera.normalize({x, y});
      corner = std::max(corner, std::hypot(p.x, p.y));
    }
  }
  return kBeyondCorners * corner;
}

}  // namespace

FrameProjection::FrameProjection(const features::CameraModel& camera, const features::LevelView& view,
                                 int zoom)
    : camera_(camera), view_(view), zoom_(zoom), farthest_(farthest(camera)) {}

std::optional<cv::Point2d> FrameProjection::at(features::LevelPoint point) const {
  const Eigen::Vector3d ray_L(point.x, point.y, 1.0);
  if (!ray_L.allFinite() || !((view_.R_LC().transpose() * ray_L).z() > 0.0)) return std::nullopt;
  const features::NormalizedPoint p = view_.tilted(point);
  if (!(std::hypot(p.x, p.y) < farthest_)) return std::nullopt;
  return zoomed(camera_.project(p));
}

// Of a circle that bends towards its normal n the arc lies on the other side of its chord, by ½ κ L² u(1 − u)
// to second order.
std::vector<cv::Point2d> FrameProjection::stretch(features::LevelPoint from, features::LevelPoint to,
                                                  double curvature, double theta_rad) const {
  const int steps = camera_.has_distortion() || curvature != 0.0 ? 24 : 1;
  const Eigen::Vector2d chord = to.vector() - from.vector(), normal(std::cos(theta_rad), std::sin(theta_rad));
  std::vector<cv::Point2d> points;
  for (int k = 0; k <= steps; ++k) {
    const double u = static_cast<double>(k) / steps;
    const double sag = 0.5 * curvature * chord.squaredNorm() * u * (1.0 - u);
    const Eigen::Vector2d p = from.vector() + u * chord - sag * normal;
    if (const auto at_px = at({p.x(), p.y()})) points.push_back(*at_px);
  }
  return points;
}

cv::Point2d FrameProjection::zoomed(features::PixelPoint frame_px) const {
  return {(frame_px.x + 0.5) * zoom_ - 0.5, (frame_px.y + 0.5) * zoom_ - 0.5};
}

}  // namespace lineservo::apps
