#pragma once

#include <Eigen/Core>

namespace lineservo::vehicle {

/// Kalman filter of three integrators in a row, ẋ₀ = x₁, ẋ₁ = x₂, ẋ₂ = noise, of which x₀ is measured.
class ChainFilter {
 public:
  /// What the filter takes to drive the chain, and to disturb its measurement.
  struct Noise {
    /// Spectral densities that drive x₀, x₁ and x₂.
    Eigen::Vector3d drive = Eigen::Vector3d::Zero();
    double measurement_sigma = 1.0;
  };

  ChainFilter(double period_s, const Noise& noise, const Eigen::Vector3d& start,
              const Eigen::Vector3d& start_sigma);

  /// One period on. `known_change` is what is known to add to the state in it.
  void predict(const Eigen::Vector3d& known_change);
  void measure(double x0);
  /// Extra doubt about one state.
  void doubt(int state, double variance) { P_(state, state) += variance; }

  const Eigen::Vector3d& state() const { return x_; }
  const Eigen::Matrix3d& covariance() const { return P_; }
  double measurement_variance() const { return R_; }
  /// For a change of frame that leaves the covariance as it is.
  void set_state(int state, double value) { x_[state] = value; }

 private:
  Eigen::Matrix3d F_;
  Eigen::Vector3d Q_;
  double R_;
  Eigen::Vector3d x_;
  Eigen::Matrix3d P_;
};

}  // namespace lineservo::vehicle
