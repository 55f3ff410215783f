#include "features/track/line_tracker.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kStartRateSigma_m_s = 0.5;
constexpr double kStartRateSigma_rad_s = 0.5;

/// (offset, θ) of a line on the branch whose θ is nearest to the expected one.
Eigen::Vector2d measurement(const LineFeature& line, double height_m, double expected_theta_rad) {
  const double half_turns = std::round((expected_theta_rad - line.theta_rad) / kPi);
  const bool mirrored = std::fmod(std::abs(half_turns), 2.0) == 1.0;
  return {(mirrored ? -line.rho : line.rho) * height_m, line.theta_rad + half_turns * kPi};
}

Eigen::Vector2d place(const Eigen::Vector4d& state) {
  return {state[0], state[2]};
}

/// Discrete white noise acceleration: q² [dt⁴/4 dt³/2; dt³/2 dt²].
Eigen::Matrix2d process_noise(double sigma, double dt_s) {
  const Eigen::Vector2d g(0.5 * dt_s * dt_s, dt_s);
  return sigma * sigma * g * g.transpose();
}

/// (ρ, θ) with θ in (−π/2, π/2].
void set_axis(LineFeature& line, double rho, double theta_rad) {
  const double half_turns = std::ceil(theta_rad / kPi - 0.5);
  const bool mirrored = std::fmod(std::abs(half_turns), 2.0) == 1.0;
  line.theta_rad = theta_rad - half_turns * kPi;
  line.rho = mirrored ? -rho : rho;
}

}  // namespace

LineTracker::LineTracker(const LineTrackerOptions& options) : options_(options) {
  const bool sound = options.offset_acceleration_m_s2 > 0.0 && options.angle_acceleration_rad_s2 > 0.0 &&
                     options.gate > 0.0 && options.let_go_rad > 0.0 && options.least_offset_sigma_m > 0.0 &&
                     options.least_angle_sigma_rad > 0.0 && options.memory_s >= 0.0;
  if (!sound)
    throw std::invalid_argument("line tracker: noise and gate must be positive, the memory not negative");
}

std::optional<TrackedLine> LineTracker::update(double dt_s, double height_m,
                                               std::span<const LineFeature> lines) {
  if (has_line_) predict(std::max(0.0, dt_s));
  if (has_line_ && (unseen_s_ > options_.memory_s || leads_elsewhere(state_[2]))) reset();
  if (!has_line_) {
    const auto first = std::find_if(lines.begin(), lines.end(), [this](const LineFeature& line) {
      return !leads_elsewhere(line.theta_rad);
    });
    if (first == lines.end()) return std::nullopt;
    start(*first, height_m);
    return TrackedLine{*expected(height_m), false};
  }
  const std::optional<Match> match = best_match(lines, height_m);
  if (match) correct(*match);
  return TrackedLine{*expected(height_m), !match};
}

std::optional<LineFeature> LineTracker::expected(double height_m) const {
  if (!has_line_) return std::nullopt;
  LineFeature line = seen_;
  set_axis(line, state_[0] / height_m, state_[2]);
  line.covariance << covariance_(0, 0) / (height_m * height_m), covariance_(0, 2) / height_m,
      covariance_(2, 0) / height_m, covariance_(2, 2);
  return line;
}

bool LineTracker::leads_elsewhere(double theta_rad) const {
  return std::abs(std::remainder(theta_rad, kPi)) > options_.let_go_rad;
}

void LineTracker::start(const LineFeature& line, double height_m) {
  const Eigen::Matrix2d R = noise(line, height_m);
  state_ = {line.rho * height_m, 0.0, line.theta_rad, 0.0};
  covariance_.setZero();
  covariance_.diagonal() << R(0, 0), kStartRateSigma_m_s * kStartRateSigma_m_s, R(1, 1),
      kStartRateSigma_rad_s * kStartRateSigma_rad_s;
  seen_ = line;
  unseen_s_ = 0.0;
  has_line_ = true;
}

void LineTracker::predict(double dt_s) {
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 1) = F(2, 3) = dt_s;
  state_ = F * state_;
  covariance_ = F * covariance_ * F.transpose();
  covariance_.topLeftCorner<2, 2>() += process_noise(options_.offset_acceleration_m_s2, dt_s);
  covariance_.bottomRightCorner<2, 2>() += process_noise(options_.angle_acceleration_rad_s2, dt_s);
  unseen_s_ += dt_s;
}

// d² = rᵀ S⁻¹ r with the innovation r = z − H x and its covariance S = H P Hᵀ + R.
std::optional<LineTracker::Match> LineTracker::best_match(std::span<const LineFeature> lines,
                                                          double height_m) const {
  Eigen::Matrix2d predicted;
  predicted << covariance_(0, 0), covariance_(0, 2), covariance_(2, 0), covariance_(2, 2);
  std::optional<Match> best;
  double best_distance = options_.gate;
  for (const LineFeature& line : lines) {
    const Eigen::Vector2d r = measurement(line, height_m, state_[2]) - place(state_);
    const Eigen::Matrix2d inverse = (predicted + noise(line, height_m)).inverse();
    const double distance = r.dot(inverse * r);
    if (!(distance < best_distance)) continue;
    best_distance = distance;
    best = Match{&line, r, inverse};
  }
  return best;
}

// K = P Hᵀ S⁻¹,   x ← x + K r,   P ← (I − K H) P.
void LineTracker::correct(const Match& match) {
  Eigen::Matrix<double, 4, 2> PHt;
  PHt << covariance_.col(0), covariance_.col(2);
  const Eigen::Matrix<double, 4, 2> K = PHt * match.inverse;
  state_ += K * match.innovation;
  covariance_ -= K * PHt.transpose();
  covariance_ = 0.5 * (covariance_ + covariance_.transpose()).eval();
  seen_ = *match.line;
  unseen_s_ = 0.0;
}

Eigen::Matrix2d LineTracker::noise(const LineFeature& line, double height_m) const {
  Eigen::Matrix2d R = line.covariance;
  R.row(0) *= height_m;
  R.col(0) *= height_m;
  R(0, 0) = std::max(R(0, 0), options_.least_offset_sigma_m * options_.least_offset_sigma_m);
  R(1, 1) = std::max(R(1, 1), options_.least_angle_sigma_rad * options_.least_angle_sigma_rad);
  return R;
}

}  // namespace lineservo::features
