#include "vehicle/body/turbulence.h"

#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {
namespace {

constexpr double kFoot_m = 0.3048;

enum Stream : std::uint64_t { kAlong = 201, kAcross, kUp };

// Of the two lags x₁' = (w − x₁)/T, x₂' = (x₁ − x₂)/T when the first has variance 1.
Eigen::Matrix2d stationary_covariance() {
  return (Eigen::Matrix2d() << 1.0, 0.5, 0.5, 0.5).finished();
}

// The lower triangle L, L Lᵀ = covariance. Over short steps the last element is rounding: never below 0.
Eigen::Matrix2d root(const Eigen::Matrix2d& covariance) {
  const double first = std::sqrt(covariance(0, 0)), mixed = covariance(1, 0) / first;
  const double last = std::sqrt(std::max(0.0, covariance(1, 1) - mixed * mixed));
  return (Eigen::Matrix2d() << first, 0.0, mixed, last).finished();
}

}  // namespace

TurbulenceScales TurbulenceScales::at_height(double height_m) {
  const double h_ft = height_m / kFoot_m;
  const double base = 0.177 + 0.000823 * h_ft;
  return {height_m / std::pow(base, 1.2), height_m, std::pow(base, 0.4)};
}

// What a step adds has the covariance Q = P − Φ P Φᵀ, so that P stays.
CrossTurbulence::CrossTurbulence(double sigma, double correlation_s, double period_s, Random& random)
    : sigma_(sigma) {
  const double share = period_s / correlation_s;
  transition_ << 1.0, 0.0, share, 1.0;
  transition_ *= std::exp(-share);
  const Eigen::Matrix2d P = stationary_covariance();
  drive_ = root(P - transition_ * P * transition_.transpose());
  lags_ = drawn(root(P), random);
}

// (1 + √3 T s) x₂ = x₂ + √3 (x₁ − x₂), of variance 2 when x₁ has 1.
double CrossTurbulence::value() const {
  return sigma_ * std::sqrt(0.5) * (lags_.y() + std::sqrt(3.0) * (lags_.x() - lags_.y()));
}

void CrossTurbulence::step(Random& random) {
  lags_ = transition_ * lags_ + drawn(drive_, random);
}

Eigen::Vector2d CrossTurbulence::drawn(const Eigen::Matrix2d& spread, Random& random) const {
  const double first = random.normal();
  return spread * Eigen::Vector2d(first, random.normal());
}

Turbulence::Turbulence(double sigma_m_s, double height_m, double passing_m_s, double period_s,
                       std::uint64_t seed)
    : along_noise_(seed, kAlong),
      across_noise_(seed, kAcross),
      up_noise_(seed, kUp),
      along_(sigma_m_s, TurbulenceScales::at_height(height_m).along_m / passing_m_s, period_s, along_noise_),
      across_(sigma_m_s, TurbulenceScales::at_height(height_m).along_m / passing_m_s, period_s,
              across_noise_),
      up_(sigma_m_s * TurbulenceScales::at_height(height_m).vertical_share,
          TurbulenceScales::at_height(height_m).vertical_m / passing_m_s, period_s, up_noise_) {}

void Turbulence::step() {
  along_.step(along_noise_);
  across_.step(across_noise_);
  up_.step(up_noise_);
}

}  // namespace lineservo::vehicle
