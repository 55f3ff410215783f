#pragma once

#include "vehicle/autopilot/gains.h"

namespace lineservo::vehicle {

/// Body rates → moments: τ = I (k (w_set − w) + ∫ k_i (w_set − w) + ẇ_set) + w × I w. The lead that a
/// derivative would give is in RotorLead, which does not amplify the gyro's noise.
class RateController {
 public:
  RateController(const AirframeParameters& airframe, const Gains& gains, double period_s);

  Eigen::Vector3d torque_B(const Eigen::Vector3d& w_set_B, const Eigen::Vector3d& w_dot_set_B,
                           const Eigen::Vector3d& w_B);
  /// Learn from the last error; left out on the ground and on axes whose moment was not had in full.
  void integrate(const Eigen::Array3d& share_of_axes);
  void forget();

 private:
  Eigen::Vector3d inertia_kg_m2_;
  Gains gains_;
  double period_s_;
  Eigen::Vector3d error_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d integral_rad_s2_ = Eigen::Vector3d::Zero();
};

}  // namespace lineservo::vehicle
