#pragma once

#include "vehicle/body/airframe.h"

namespace lineservo::vehicle {

/// Thrust along z_B and moments in B, as wanted or as got.
struct ThrustAndTorque {
  double thrust_N = 0.0;
  Eigen::Vector3d torque_B_Nm = Eigen::Vector3d::Zero();
};

/// Shares thrust and moments out among the rotors. What they cannot do all together is given up in the order
/// yaw, thrust, roll and pitch.
class Mixer {
 public:
  explicit Mixer(const AirframeParameters& airframe);

  /// Each rotor's thrust, within what it can do.
  PerRotor rotor_thrusts_N(const ThrustAndTorque& wanted) const;
  ThrustAndTorque result(const PerRotor& rotor_thrusts_N) const;

  double least_thrust_N() const { return least_N_; }
  double greatest_thrust_N() const { return greatest_N_; }

 private:
  PerRotor tilting_part(const Eigen::Vector3d& torque_B_Nm) const;
  double thrust_that_fits(double wanted_N, const PerRotor& tilting_N) const;
  double share_that_fits(const PerRotor& base_N, const PerRotor& extra_N) const;

  Eigen::Matrix4d from_rotors_, to_rotors_;
  double least_N_, greatest_N_;
};

}  // namespace lineservo::vehicle
