#include "features/junction/visible_arms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

/// A convex polygon of at most eight corners: a rectangle cut by the four sides of the image.
struct Polygon {
  std::array<Eigen::Vector2d, 8> corner;
  std::size_t size = 0;

  void add(const Eigen::Vector2d& p) {
    if (size < corner.size()) corner[size++] = p;
  }
};

// Sutherland and Hodgman: keeps the part where sign · (p[axis] − limit) ≤ 0.
Polygon cut(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const Eigen::Vector2d& a = polygon.corner[k];
    const Eigen::Vector2d& b = polygon.corner[(k + 1) % polygon.size];
    const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
    if (da <= 0.0) kept.add(a);
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) kept.add(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

Eigen::Vector2d extent(const Polygon& polygon) {
  if (polygon.size == 0) return Eigen::Vector2d::Zero();
  Eigen::Vector2d low = polygon.corner[0], high = low;
  for (std::size_t k = 1; k < polygon.size; ++k) {
    low = low.cwiseMin(polygon.corner[k]);
    high = high.cwiseMax(polygon.corner[k]);
  }
  return high - low;
}

// Forward of the vehicle is −y of L, left is −x.
Eigen::Vector2d direction_of(double angle_rad) {
  return {-std::sin(angle_rad), -std::cos(angle_rad)};
}

}  // namespace

Eigen::Vector2d visible_arm_size_px(const LevelMask& mask, LevelPoint centre, const JunctionArm& arm) {
  constexpr double beyond_view = 0.3;  // past the edge of the image, for the cut to be the edge's
  const Eigen::Vector2d along = direction_of(arm.feature.angle_rad);
  const Eigen::Vector2d half_across = 0.5 * arm.width * Eigen::Vector2d(-along.y(), along.x());
  const double from = 0.5 * arm.width;
  const double to = from + arm.feature.length + (arm.leaves_view ? beyond_view : 0.0);
  Polygon polygon;
  for (const auto& [distance, side] : {std::pair{from, -1.0}, {to, -1.0}, {to, 1.0}, {from, 1.0}}) {
    const PixelPoint px = mask.project(centre.vector() + distance * along + side * half_across);
    polygon.add({px.x, px.y});
  }
  polygon = cut(polygon, 0, -0.5, -1.0);
  polygon = cut(polygon, 0, mask.mask().width - 0.5, 1.0);
  polygon = cut(polygon, 1, -0.5, -1.0);
  polygon = cut(polygon, 1, mask.mask().height - 0.5, 1.0);
  return extent(polygon);
}

Arms visible_arms(const LevelMask& mask, LevelPoint centre, const std::vector<JunctionArm>& arms,
                  const ArmVisibility& rule) {
  Arms seen;
  for (const JunctionArm& arm : arms) {
    const int quarter = static_cast<int>(std::lround(arm.feature.angle_rad / (kPi / 2.0)));  // −2 … 2
    if (std::abs(arm.feature.angle_rad - quarter * (kPi / 2.0)) > rule.max_off_axis_rad) continue;
    const bool lengthwise = quarter % 2 == 0;  // along image y
    const Eigen::Vector2d size_px = visible_arm_size_px(mask, centre, arm);
    const double along_px = lengthwise ? size_px.y() : size_px.x();
    const double across_px = lengthwise ? size_px.x() : size_px.y();
    if (along_px < rule.min_px || across_px < rule.min_px - rule.across_slack_px) continue;
    (quarter == 0 ? seen.forward : !lengthwise ? (quarter > 0 ? seen.left : seen.right) : seen.back) = true;
  }
  return seen;
}

}  // namespace lineservo::features
