#include "servo/law/motion.h"

#include <cmath>

namespace lineservo::servo {

Motion compose(const Motion& first, const Motion& second) {
  return {first.translation_m + Eigen::Rotation2Dd(first.yaw_rad) * second.translation_m,
          first.yaw_rad + second.yaw_rad};
}

Motion between(const Motion& from, const Motion& to) {
  return {Eigen::Rotation2Dd(-from.yaw_rad) * (to.translation_m - from.translation_m),
          to.yaw_rad - from.yaw_rad};
}

// A yaw of the vehicle by ψ turns the line in the image by +ψ: θ' = θ + ψ. The foot of the perpendicular
// moves with the floor: ρ' = n'ᵀ p', with any point p of the line. Where the line bends, the foot moves on by
// s along it, and the tangent there is θ' + κs at ρ' + κs²/2 (to second order in s).
features::LineFeature after(const Motion& motion, features::LineFeature line, double height_m) {
  const features::LevelPoint foot{line.rho * std::cos(line.theta_rad), line.rho * std::sin(line.theta_rad)};
  const features::LevelPoint moved = level_point(after(motion, floor_point_m(foot, height_m)), height_m);
  line.theta_rad += motion.yaw_rad;
  const double c = std::cos(line.theta_rad), s = std::sin(line.theta_rad);
  line.rho = moved.x * c + moved.y * s;
  const double tangent = moved.y * c - moved.x * s;  // from the old foot forward to beside the new one
  const double along = tangent / (1.0 + line.curvature * line.rho);
  line.theta_rad += line.curvature * along;
  line.rho += 0.5 * line.curvature * along * along;
  return line;
}

}  // namespace lineservo::servo
