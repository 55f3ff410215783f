#include "features/line/curved_course.h"

namespace lineservo::features {
namespace {

constexpr double kStraight = 1e-9;  // of curvature

}  // namespace

// p = foot + f sin(κs)/κ + n (1 − cos(κs))/κ, and the normal there is n cos(κs) − f sin(κs).
Eigen::Vector2d CurvedCourse::at(double along, double across) const {
  const Eigen::Vector2d n = normal(), f = forward();
  if (std::abs(curvature) < kStraight) return foot + along * f + across * n;
  const double turn = curvature * along, s = std::sin(turn), c = std::cos(turn);
  return foot + (s / curvature) * f + ((1.0 - c) / curvature) * n + across * (c * n - s * f);
}

double CurvedCourse::along(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - foot;
  const double t = q.dot(forward()), u = q.dot(normal());
  if (std::abs(curvature) < kStraight) return t;
  return std::atan2(curvature * t, 1.0 - curvature * u) / curvature;
}

// With F = u − κ (u² + t²)/2 the distance from a circle of curvature κ that touches the forward axis at the
// foot is 2F/(1 + √(1 − 2κF)): exact, and well behaved down to κ = 0.
double CurvedCourse::across(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - foot;
  const double F = q.dot(normal()) - 0.5 * curvature * q.squaredNorm();
  return 2.0 * F / (1.0 + std::sqrt(std::max(0.0, 1.0 - 2.0 * curvature * F)));
}

}  // namespace lineservo::features
