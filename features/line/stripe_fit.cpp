#include "features/line/stripe_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kFacing = 0.966;  // cos 15°: a border point must look the stripe's way
constexpr int kMinPoints = 8;
constexpr int kIterations = 5;
constexpr double kFirstReach = 0.03;   // Tukey's cut-off at the start: three bins of the vote
constexpr double kLeastReach = 0.008;  // and at the end: 1.5 mask pixels
constexpr double kTukey = 4.685;       // cut-off in σ for 95 % efficiency
// A border along the pixel grid is rounded the same way all over: averaging does not help that.
constexpr double kFloor_rho = 5e-4;
constexpr double kFloor_theta_rad = 2e-4;

struct NormalEquations {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();  // of (dθ, dρ, dw)
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double weight = 0.0, squares = 0.0, rising_length = 0.0, falling_length = 0.0;
  int points = 0;
};

// r = p·n(θ) − ρ ± w/2 (+ where the paint lies at larger ρ), so with t = p·n'(θ): dr = t dθ − dρ ± dw/2.
NormalEquations accumulate(std::span<const BorderPoint> points, const StripeCourse& course, double reach) {
  NormalEquations sums;
  const Eigen::Vector2d n = course.normal();
  const Eigen::Vector2d tangent = -course.forward();
  const double per_reach = 1.0 / (reach * reach);
  double tt = 0.0, t1 = 0.0, ts = 0.0, ss = 0.0, s1 = 0.0, rt = 0.0, r1 = 0.0, rs = 0.0;
  double weight = 0.0, squares = 0.0;  // all of them in registers
  for (const BorderPoint& point : points) {
    const double facing = point.normal.dot(n);
    if (std::abs(facing) < kFacing) continue;
    const double side = static_cast<double>(facing > 0.0) - 0.5;
    const double r = point.p_L.dot(n) - course.rho + side * course.width;
    const double u = 1.0 - r * r * per_reach;
    if (u <= 0.0) continue;
    const double w = u * u, t = point.p_L.dot(tangent), wt = w * t, wr = w * r;
    tt += wt * t;
    t1 += wt;
    ts += wt * side;
    s1 += w * side;
    ss += w * side * side;
    rt += wr * t;
    r1 += wr;
    rs += wr * side;
    weight += w;
    squares += wr * r;
    (facing > 0.0 ? sums.rising_length : sums.falling_length) += point.length;
    ++sums.points;
  }
  sums.A << tt, -t1, ts, -t1, weight, -s1, ts, -s1, ss;
  sums.b << -rt, r1, -rs;
  sums.weight = weight;
  sums.squares = squares;
  return sums;
}

// The points that a course may come to rest on: worn paint has many more that look its way. Later rounds look
// at these alone, as long as the course stays within the slack.
class Neighbours {
 public:
  explicit Neighbours(std::span<const BorderPoint> all) : all_(all) {}

  std::span<const BorderPoint> of(const StripeCourse& course) {
    if (near_.empty() || !holds(course)) collect(course);
    return near_;
  }

 private:
  static constexpr double kSlack_rad = radians(10.0), kSlack = 0.05, kFarthest = 2.5;

  bool holds(const StripeCourse& course) const {
    const double turn_rad = std::abs(course.theta_rad - centre_.theta_rad);
    const double shift = std::abs(course.rho - centre_.rho) + 0.5 * std::abs(course.width - centre_.width);
    return turn_rad < kSlack_rad && shift + kFarthest * turn_rad < kSlack;
  }

  void collect(const StripeCourse& course) {
    static const double least_facing = std::cos(std::acos(kFacing) + kSlack_rad);
    centre_ = course;
    near_.resize(all_.size());
    std::size_t kept = 0;
    const Eigen::Vector2d n = course.normal();
    for (const BorderPoint& point : all_) {
      near_[kept] = point;
      const bool faces = std::abs(point.normal.dot(n)) >= least_facing;
      const bool is_near = std::abs(border_residual(point, course, n)) <= kFirstReach + kSlack;
      kept += static_cast<std::size_t>(faces & is_near);
    }
    near_.resize(kept);
  }

  std::span<const BorderPoint> all_;
  std::vector<BorderPoint> near_;
  StripeCourse centre_;
};

void hold_width(NormalEquations& sums) {
  sums.A.row(2).setZero();
  sums.A.col(2).setZero();
  sums.A(2, 2) = 1.0;
  sums.b(2) = 0.0;
}

bool well_posed(const NormalEquations& sums, WidthIs width) {
  if (sums.points < kMinPoints) return false;
  return width == WidthIs::known || (sums.rising_length > 0.0 && sums.falling_length > 0.0);
}

}  // namespace

StripeCourse canonical(StripeCourse course) {
  course.theta_rad = wrap_angle(course.theta_rad);
  if (course.theta_rad > kPi / 2.0 || course.theta_rad <= -kPi / 2.0) {
    course.theta_rad = wrap_angle(course.theta_rad + kPi);
    course.rho = -course.rho;
  }
  return course;
}

std::optional<StripeFit> fit_stripe(std::span<const BorderPoint> points, const StripeCourse& start,
                                    WidthIs width) {
  StripeFit fit{.course = start};
  Neighbours neighbours(points);
  double reach = kFirstReach;
  for (int iteration = 0;; ++iteration) {
    NormalEquations sums = accumulate(neighbours.of(fit.course), fit.course, reach);
    if (!well_posed(sums, width)) return std::nullopt;
    if (width == WidthIs::known) hold_width(sums);
    const Eigen::LDLT<Eigen::Matrix3d> ldlt(sums.A);
    const Eigen::Vector3d step = ldlt.solve(sums.b);
    if (!step.allFinite()) return std::nullopt;
    fit.course.theta_rad += step(0);
    fit.course.rho += step(1);
    fit.course.width += step(2);
    fit.scatter = std::sqrt(sums.squares / sums.weight);
    fit.rising_length = sums.rising_length;
    fit.falling_length = sums.falling_length;
    const bool settled = iteration >= 2 && step.cwiseAbs().maxCoeff() < 1e-5;
    if (iteration + 1 == kIterations || settled) {
      const double variance = std::max(fit.scatter * fit.scatter, 1e-6);
      const Eigen::Matrix3d C = variance * ldlt.solve(Eigen::Matrix3d::Identity());
      fit.covariance << C(1, 1) + kFloor_rho * kFloor_rho, C(1, 0),  //
          C(0, 1), C(0, 0) + kFloor_theta_rad * kFloor_theta_rad;
      break;
    }
    reach = std::clamp(kTukey * fit.scatter, kLeastReach, kFirstReach);
  }
  if (!(fit.course.width > 0.0)) return std::nullopt;
  const bool mirrored = std::abs(wrap_angle(fit.course.theta_rad)) > kPi / 2.0;
  fit.course = canonical(fit.course);
  if (mirrored) {
    std::swap(fit.rising_length, fit.falling_length);
    fit.covariance(0, 1) = -fit.covariance(0, 1);
    fit.covariance(1, 0) = fit.covariance(0, 1);
  }
  return fit;
}

}  // namespace lineservo::features
