#include "servo/law/carrot_chase.h"

#include <cmath>

#include "features/geometry/angles.h"
#include "servo/law/published_followers.h"

namespace lineservo::servo {
namespace {

bool is_seen(const std::optional<features::LevelPoint>& p) {
  return p && p->vector().allFinite();
}

double direction(const Eigen::Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

}  // namespace

std::optional<CarrotPath> carrot_path(const features::LawFeatures& seen) {
  CarrotPath path{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  if (is_seen(seen.behind)) path.behind_px = published_px(*seen.behind);
  if (is_seen(seen.ahead)) path.ahead_px = published_px(*seen.ahead);
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
