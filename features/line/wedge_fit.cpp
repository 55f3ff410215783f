#include "features/line/wedge_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kFacing = 0.94;      // cos 20°: a border point must look the stripe's way
constexpr double kFirstReach = 0.05;  // Tukey's cut-off at the start
constexpr double kReachWidths = 0.2;  // and in widths of the stripe
constexpr double kLeastReach = 0.008;
constexpr double kTukey = 4.685;  // cut-off in σ for 95 % efficiency
constexpr double kMargin = 0.02;  // points beyond the ends belong to caps
constexpr int kIterations = 8;
constexpr int kMinPoints = 12;

struct Sums {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();  // of (dθ, dρ, dw, dc)
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  double weight = 0.0, squares = 0.0, rising = 0.0, falling = 0.0;
  int points = 0;
};

struct Range {
  double from, to;
};

// With a = along − at_along and the width w + c a, a border point on side ½ s (+ where the paint lies at
// larger ρ) has r = p·n(θ) − ρ + ½ s (w + c a), so dr = p·n'(θ) dθ − dρ + ½ s dw + ½ s a dc.
Sums accumulate(const std::vector<BorderPoint>& points, const Wedge& wedge, const Range& range,
                double reach) {
  Sums sums;
  const Eigen::Vector2d n = wedge.course.normal(), forward = wedge.course.forward();
  for (const BorderPoint& point : points) {
    const double facing = point.normal.dot(n);
    const double along = point.p_L.dot(forward);
    if (std::abs(facing) < kFacing || along < range.from - kMargin || along > range.to + kMargin) continue;
    const double side = facing > 0.0 ? 0.5 : -0.5;
    const double a = along - wedge.at_along;
    const double r =
        point.p_L.dot(n) - wedge.course.rho + side * (wedge.course.width + wedge.convergence * a);
    const double u = 1.0 - r * r / (reach * reach);
    if (u <= 0.0) continue;
    const double w = u * u;
    const Eigen::Vector4d gradient(-along, -1.0, side, side * a);
    sums.A += w * gradient * gradient.transpose();
    sums.b -= w * r * gradient;
    sums.weight += w;
    sums.squares += w * r * r;
    (facing > 0.0 ? sums.rising : sums.falling) += point.length;
    ++sums.points;
  }
  return sums;
}

void step(Wedge& wedge, const Eigen::Vector4d& by) {
  wedge.course.theta_rad += by(0);
  wedge.course.rho += by(1);
  wedge.course.width += by(2);
  wedge.convergence += by(3);
}

Wedge canonical(Wedge wedge) {
  StripeCourse& course = wedge.course;
  course.theta_rad = wrap_angle(course.theta_rad);
  if (course.theta_rad > kPi / 2.0 || course.theta_rad <= -kPi / 2.0) {
    course.theta_rad = wrap_angle(course.theta_rad + kPi);
    course.rho = -course.rho;
    wedge.convergence = -wedge.convergence;
    wedge.at_along = -wedge.at_along;
  }
  return wedge;
}

bool strays(const Wedge& wedge, const StripeCourse& start, const WedgeOptions& options) {
  const Eigen::Vector2d middle = StripeAxes(start).at(wedge.at_along, 0.0);
  const double moved = std::abs(middle.dot(wedge.course.normal()) - wedge.course.rho);
  return std::abs(wedge.convergence) > options.max_convergence || !(wedge.course.width > 0.0) ||
         std::abs(wrap_angle(wedge.course.theta_rad - start.theta_rad)) > options.max_turn_rad ||
         moved > 0.5 * start.width;
}

}  // namespace

std::optional<Wedge> fit_wedge(const std::vector<BorderPoint>& points, const StripeCourse& start, double from,
                               double to, const WedgeOptions& options) {
  Wedge wedge{.course = start, .at_along = 0.5 * (from + to)};
  const double first_reach = std::max(kFirstReach, kReachWidths * start.width);
  double reach = first_reach;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Sums sums = accumulate(points, wedge, {from, to}, reach);
    if (sums.points < kMinPoints || sums.rising <= 0.0 || sums.falling <= 0.0) return std::nullopt;
    const Eigen::Vector4d by = sums.A.ldlt().solve(sums.b);
    if (!by.allFinite()) return std::nullopt;
    step(wedge, by);
    if (strays(wedge, start, options)) return std::nullopt;
    wedge.support = sums.rising + sums.falling;
    wedge.scatter = std::sqrt(sums.squares / sums.weight);
    reach = std::clamp(kTukey * wedge.scatter, kLeastReach, first_reach);
  }
  return canonical(wedge);
}

}  // namespace lineservo::features
