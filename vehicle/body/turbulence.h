#pragma once

#include <Eigen/Core>

#include "vehicle/random.h"
#include "vehicle/sensors/gauss_markov.h"

namespace lineservo::vehicle {

/// Scales of turbulence near the ground, MIL-F-8785C §3.7.3.4: with h in feet
///   L_w = h,   L_u = L_v = h / (0.177 + 0.000823 h)^1.2,   σ_w = σ_u (0.177 + 0.000823 h)^0.4,   σ_v = σ_u.
/// The standard gives them from 10 ft up. Below that they are carried on: the scales get shorter, which is
/// harder on the controller than holding them at 10 ft.
struct TurbulenceScales {
  double along_m = 0.0;         ///< L_u = L_v
  double vertical_m = 0.0;      ///< L_w
  double vertical_share = 0.0;  ///< σ_w over σ_u

  static TurbulenceScales at_height(double height_m);
};

/// Wind across the mean wind or up, the second of Dryden's forms. White noise of unit intensity through
///   H(s) = σ √T (1 + √3 T s) / (1 + T s)² (up to its constant),   T = L/V,
/// has R(τ) = σ² e^(−τ/T) (1 − τ/2T). Two lags in a row, stepped by their exact transition
/// e^(−h/T) [1 0; h/T 1], stationary from the start.
class CrossTurbulence {
 public:
  CrossTurbulence(double sigma, double correlation_s, double period_s, Random& random);
  double value() const;
  void step(Random& random);

 private:
  Eigen::Vector2d drawn(const Eigen::Matrix2d& spread, Random& random) const;

  double sigma_;
  Eigen::Matrix2d transition_;
  Eigen::Matrix2d drive_;  ///< root of the covariance of what a step adds
  Eigen::Vector2d lags_;
};

/// Dryden turbulence as a vehicle meets it that the air passes at one speed: along the mean wind
/// R(τ) = σ² e^(−τ/T) (exact first-order process), across it and up see CrossTurbulence.
class Turbulence {
 public:
  /// σ of the horizontal components; scales of a height; the speed at which the air passes, above 0.
  Turbulence(double sigma_m_s, double height_m, double passing_m_s, double period_s, std::uint64_t seed);

  /// Along the mean wind, to its left, up.
  Eigen::Vector3d value() const { return {along_.value(), across_.value(), up_.value()}; }
  void step();

 private:
  Random along_noise_, across_noise_, up_noise_;
  GaussMarkov along_;
  CrossTurbulence across_, up_;
};

}  // namespace lineservo::vehicle
