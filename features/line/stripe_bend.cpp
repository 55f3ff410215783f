#include "features/line/stripe_bend.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"
#include "features/line/course_view.h"

namespace lineservo::features {
namespace {

constexpr double kAlongTheStripe_rad = radians(40.0);  // borders that cross it further belong to side arms
constexpr int kFewest = 24;
constexpr double kLeastSigma = 5e-4;
constexpr double kLeastReach = 0.004;  // Tukey's cut-off never falls below about a pixel of the mask

/// The border points that may be the stripe's, and how far each is from the straight one.
struct Borders {
  std::vector<EdgePoint> points;
  std::vector<double> along, residual;

  void reserve(std::size_t count) {
    points.reserve(count);
    along.reserve(count);
    residual.reserve(count);
  }
};

Borders borders_near(const std::vector<BorderPoint>& points, const Stripe& stripe, double reach) {
  const StripeAxes axes(stripe.course);
  const double from = stripe.begin.along - reach, to = stripe.end.along + reach;
  const double least_cosine = std::cos(kAlongTheStripe_rad);
  // The paint begins on the side away from the normal.
  const auto side = [&axes](const BorderPoint& p) { return 1 - 2 * int{p.normal.dot(axes.normal()) > 0.0}; };
  const auto residual = [&](const BorderPoint& p) {
    return axes.across(p.p_L) - 0.5 * side(p) * axes.width();
  };
  std::vector<const BorderPoint*> near(points.size());
  std::size_t kept = 0;
  for (const BorderPoint& point : points) {  // without branches, as worn paint cannot be predicted
    const double along = axes.along(point.p_L);
    const bool aligned = std::abs(point.normal.dot(axes.normal())) >= least_cosine;
    const bool beside = (std::abs(residual(point)) <= reach) & (along >= from) & (along <= to);
    near[kept] = &point;
    kept += static_cast<std::size_t>(aligned & beside);
  }
  near.resize(kept);
  Borders borders;
  borders.reserve(kept);
  for (const BorderPoint* point : near) {
    borders.points.push_back({point->p_L, static_cast<double>(side(*point))});
    borders.along.push_back(axes.along(point->p_L));
    borders.residual.push_back(residual(*point));
  }
  return borders;
}

/// r = a + b t + ½ κ t² by least squares, cheap enough for every frame: is there a bend worth a robust fit?
bool looks_bent(const Borders& borders, const BendOptions& options) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (std::size_t k = 0; k < borders.along.size(); ++k) {
    const double t = borders.along[k], r = borders.residual[k];
    const Eigen::Vector3d g(1.0, t, 0.5 * t * t);
    A.noalias() += g * g.transpose();
    b += r * g;
    squares += r * r;
  }
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(A);
  const Eigen::Vector3d x = ldlt.solve(b);
  const double left = std::max(0.0, squares - b.dot(x)) / static_cast<double>(borders.along.size());
  const double sigma = std::sqrt(left * ldlt.solve(Eigen::Vector3d::UnitZ()).z());
  return x.allFinite() && std::abs(x.z()) > options.significance * sigma;
}

}  // namespace

std::optional<LineFeature> fit_bend(const std::vector<BorderPoint>& points, const Stripe& stripe,
                                    const BendOptions& options) {
  const Borders borders = borders_near(points, stripe, options.reach);
  if (std::ssize(borders.points) < kFewest || !looks_bent(borders, options)) return std::nullopt;
  const auto [first, last] = std::minmax_element(borders.along.begin(), borders.along.end());
  const double middle = 0.5 * (*first + *last), half = 0.5 * (*last - *first);
  const auto fit = fit_borders(borders.points, CurvedCourse::straight(stripe.course, middle),
                               {.width = stripe.both_borders, .curvature = true}, options.reach, kLeastReach);
  if (!fit) return std::nullopt;
  const double kappa = std::abs(fit->course.curvature);
  const bool is_bent =
      kappa > options.significance * fit->curvature_sigma && 0.5 * kappa * half * half > options.least_sag;
  if (!is_bent || 2 * fit->supporters < std::ssize(borders.points)) return std::nullopt;
  const CourseStretch stretch{-half, half};
  const double along = std::clamp(fit->course.along(Eigen::Vector2d::Zero()), -half, half);
  return level_tangent(*fit, stretch, along, stripe.feature.quality, kLeastSigma);
}

}  // namespace lineservo::features
