#include "features/line/curved_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace lineservo::features {
namespace {

constexpr int kParameters = 5;  // offset, θ, width, curvature, taper
constexpr int kMinPoints = 8;
constexpr int kIterations = 12;
constexpr double kTukey = 4.685;           // cut-off in σ for 95 % efficiency
constexpr double kMedianToSigma = 1.4826;  // of a normal distribution
using Matrix = Eigen::Matrix<double, kParameters, kParameters>;
using Vector = Eigen::Matrix<double, kParameters, 1>;

double residual(const EdgePoint& point, const CurvedCourse& course) {
  return course.across(point.p) - 0.5 * point.side * course.width_at(course.along(point.p));
}

// With u across and t along the tangent at the foot, to first order in the curvature:
// dr = −d(offset) − t dθ ∓ dw/2 − (u² + t²)/2 dκ ∓ t/2 dτ.
Vector gradient(const EdgePoint& point, const CurvedCourse& course) {
  const Eigen::Vector2d q = point.p - course.foot;
  const double t = q.dot(course.forward());
  return {-1.0, -t, -0.5 * point.side, -0.5 * q.squaredNorm(), -0.5 * point.side * t};
}

struct NormalEquations {
  Matrix A = Matrix::Zero();
  Vector b = Vector::Zero();
  double weight = 0.0, squares = 0.0;
  int points = 0;
};

NormalEquations accumulate(const std::vector<EdgePoint>& points, const CurvedCourse& course, double reach) {
  NormalEquations sums;
  for (const EdgePoint& point : points) {
    const double r = residual(point, course);
    const double u = 1.0 - (r * r) / (reach * reach);
    if (u <= 0.0) continue;
    const double w = u * u;
    const Vector g = gradient(point, course);
    sums.A.noalias() += w * g * g.transpose();
    sums.b -= w * r * g;
    sums.weight += w;
    sums.squares += w * r * r;
    ++sums.points;
  }
  return sums;
}

void hold(NormalEquations& sums, int parameter) {
  sums.A.row(parameter).setZero();
  sums.A.col(parameter).setZero();
  sums.A(parameter, parameter) = 1.0;
  sums.b(parameter) = 0.0;
}

void hold_fixed(NormalEquations& sums, const FreeShape& shape) {
  if (!shape.width) hold(sums, 2);
  if (!shape.curvature) hold(sums, 3);
  if (!shape.taper) hold(sums, 4);
}

void apply(const Vector& step, CurvedCourse& course) {
  course.foot += step(0) * course.normal();
  course.theta_rad += step(1);
  course.width += step(2);
  course.curvature += step(3);
  course.taper += step(4);
}

double robust_reach(const std::vector<EdgePoint>& points, const CurvedCourse& course, double reach,
                    double least_reach) {
  std::vector<double> sizes;
  sizes.reserve(points.size());
  for (const EdgePoint& point : points) {
    const double size = std::abs(residual(point, course));
    if (size < reach) sizes.push_back(size);
  }
  if (sizes.empty()) return reach;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::clamp(kTukey * kMedianToSigma * *middle, least_reach, reach);
}

void state_uncertainty(const NormalEquations& sums, const Eigen::LDLT<Matrix>& ldlt, const FreeShape& shape,
                       CurvedFit& fit) {
  const Matrix C = (fit.scatter * fit.scatter) * ldlt.solve(Matrix::Identity());
  fit.covariance = C.topLeftCorner<2, 2>();
  if (shape.curvature) fit.curvature_sigma = std::sqrt(std::max(0.0, C(3, 3)));
  if (shape.taper) fit.taper_sigma = std::sqrt(std::max(0.0, C(4, 4)));
  fit.supporters = sums.points;
}

}  // namespace

std::optional<CurvedFit> fit_borders(const std::vector<EdgePoint>& points, const CurvedCourse& start,
                                     const FreeShape& shape, double reach, double least_reach) {
  CurvedFit fit{.course = start};
  double cut = robust_reach(points, start, reach, std::max(least_reach, 0.5 * reach));
  for (int iteration = 0;; ++iteration) {
    NormalEquations sums = accumulate(points, fit.course, cut);
    if (sums.points < kMinPoints) return std::nullopt;
    hold_fixed(sums, shape);
    const Eigen::LDLT<Matrix> ldlt(sums.A);
    const Vector step = ldlt.solve(sums.b);
    if (!step.allFinite()) return std::nullopt;
    apply(step, fit.course);
    fit.scatter = std::sqrt(sums.squares / sums.weight);
    if (iteration + 1 == kIterations || (iteration >= 3 && step.cwiseAbs().maxCoeff() < 1e-8)) {
      if (!(fit.course.width > 0.0)) return std::nullopt;
      state_uncertainty(sums, ldlt, shape, fit);
      return fit;
    }
    cut = robust_reach(points, fit.course, reach, least_reach);
  }
}

}  // namespace lineservo::features
