#include "servo/law/carrot_chase.h"

#include <cmath>

#include "features/geometry/angles.h"
#include "servo/law/published_followers.h"

namespace lineservo::servo {
namespace {

using features::LevelPoint;

struct Ends {
  std::optional<LevelPoint> behind, ahead;
};

Ends ends_in_view(const Observation& o) {
  if (on_plain_line(o)) return {o.features.law.behind, o.features.law.ahead};
  if (const features::LineFeature* line = line_to_follow(o)) return {line->begin, line->end};
  return {};
}

Eigen::Vector2d px_or_centre(const std::optional<LevelPoint>& p) {
  return p && p->vector().allFinite() ? published_px(*p) : Eigen::Vector2d::Zero();
}

double direction(const Eigen::Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

}  // namespace

std::optional<CarrotPath> carrot_path(const Observation& observation) {
  const Ends ends = ends_in_view(observation);
  const CarrotPath path{px_or_centre(ends.behind), px_or_centre(ends.ahead)};
  if ((path.ahead_px - path.behind_px).norm() < 1.0) return std::nullopt;
  return path;
}

// Alg. 1, lines 6 to 10, with p = 0, the image's centre, and ψ = 0, straight up in the image. The axes are
// forward and left, so that angles grow counter-clockwise seen from above.
double carrot_turn_rad(const CarrotPath& path, double delta_px) {
  const Eigen::Vector2d to_p = -path.behind_px;  // p − W_i
  const double theta = direction(path.ahead_px - path.behind_px);
  const double beta = theta - direction(to_p);
  const double along_px = std::abs(to_p.norm() * std::cos(beta));  // R = √(R_u² − (R_u sinβ)²)
  const Eigen::Vector2d carrot =
      path.behind_px + (along_px + delta_px) * Eigen::Vector2d(std::cos(theta), std::sin(theta));
  return features::wrap_angle(direction(carrot));
}

}  // namespace lineservo::servo
