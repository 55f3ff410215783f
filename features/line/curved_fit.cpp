#include "features/line/curved_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace lineservo::features {
namespace {

constexpr int kParameters = 5;  // offset, θ, width, curvature, taper
constexpr int kMinPoints = 8;
constexpr int kIterations = 12;
constexpr double kSettled = 1e-7;          // a ten-thousandth of a pixel
constexpr double kTukey = 4.685;           // cut-off in σ for 95 % efficiency
constexpr double kMedianToSigma = 1.4826;  // of a normal distribution
using Matrix = Eigen::Matrix<double, kParameters, kParameters>;
using Vector = Eigen::Matrix<double, kParameters, 1>;

// A course at hand for many points: its directions are worked out once.
class Borders {
 public:
  explicit Borders(const CurvedCourse& course)
      : course_(course), normal_(course.normal()), forward_(course.forward()) {}

  struct Point {
    double along, across;  // of the axes through the foot
  };
  Point local(const EdgePoint& point) const {
    const Eigen::Vector2d q = point.p - course_.foot;
    return {q.dot(forward_), q.dot(normal_)};
  }

  /// The distance from the point's own border: as CurvedCourse::across(), the width taken at the foot of the
  /// tangent.
  double residual(const Point& q, double side) const {
    const double half = 0.5 * side * course_.width_at(q.along), kappa = course_.curvature;
    if (kappa == 0.0) return q.across - half;
    const double F = q.across - 0.5 * kappa * (q.along * q.along + q.across * q.across);
    return 2.0 * F / (1.0 + std::sqrt(std::max(0.0, 1.0 - 2.0 * kappa * F))) - half;
  }

  // With u across and t along the tangent at the foot, to first order in the curvature:
  // dr = −d(offset) − t dθ ∓ dw/2 − (u² + t²)/2 dκ ∓ t/2 dτ.
  static Vector gradient(const Point& q, double side) {
    return {-1.0, -q.along, -0.5 * side, -0.5 * (q.along * q.along + q.across * q.across),
            -0.5 * side * q.along};
  }

 private:
  const CurvedCourse& course_;
  Eigen::Vector2d normal_, forward_;
};

struct NormalEquations {
  Matrix A = Matrix::Zero();
  Vector b = Vector::Zero();
  double weight = 0.0, squares = 0.0;
  int points = 0;
};

NormalEquations accumulate(const std::vector<EdgePoint>& points, const CurvedCourse& course, double reach) {
  NormalEquations sums;
  const Borders borders(course);
  for (const EdgePoint& point : points) {
    const Borders::Point q = borders.local(point);
    const double r = borders.residual(q, point.side);
    const double u = 1.0 - (r * r) / (reach * reach);
    if (u <= 0.0) continue;
    const double w = u * u;
    const Vector g = Borders::gradient(q, point.side);
    sums.A.selfadjointView<Eigen::Lower>().rankUpdate(g, w);
    sums.b -= (w * r) * g;
    sums.weight += w;
    sums.squares += w * r * r;
    ++sums.points;
  }
  sums.A = Matrix(sums.A.selfadjointView<Eigen::Lower>());
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
  const Borders borders(course);
  for (const EdgePoint& point : points) {
    const double size = std::abs(borders.residual(borders.local(point), point.side));
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
    if (iteration + 1 == kIterations || (iteration >= 3 && step.cwiseAbs().maxCoeff() < kSettled)) {
      if (!(fit.course.width > 0.0)) return std::nullopt;
      state_uncertainty(sums, ldlt, shape, fit);
      return fit;
    }
    cut = robust_reach(points, fit.course, reach, least_reach);
  }
}

}  // namespace lineservo::features
