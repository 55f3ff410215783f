#include "vehicle/autopilot/mixer.h"

#include <Eigen/LU>
#include <algorithm>

namespace lineservo::vehicle {
namespace {

// A rotor that stands still answers late: in flight none turns slower than this share of its greatest speed.
constexpr double kIdleSpeedShare = 0.08;

}  // namespace

Mixer::Mixer(const AirframeParameters& airframe)
    : from_rotors_(airframe.allocation()),
      to_rotors_(from_rotors_.inverse()),
      least_N_(kIdleSpeedShare * kIdleSpeedShare * airframe.max_rotor_thrust_N()),
      greatest_N_(airframe.max_rotor_thrust_N()) {}

PerRotor Mixer::rotor_thrusts_N(const ThrustAndTorque& wanted) const {
  const PerRotor tilting_N = tilting_part(wanted.torque_B_Nm);
  const double thrust_N = thrust_that_fits(wanted.thrust_N, tilting_N);
  const PerRotor base_N = tilting_N + to_rotors_.col(0) * thrust_N;
  const PerRotor yawing_N = to_rotors_.col(3) * wanted.torque_B_Nm.z();
  const PerRotor all_N = base_N + share_that_fits(base_N, yawing_N) * yawing_N;
  return all_N.cwiseMax(least_N_).cwiseMin(greatest_N_);
}

ThrustAndTorque Mixer::result(const PerRotor& rotor_thrusts_N) const {
  const Eigen::Vector4d sums = from_rotors_ * rotor_thrusts_N;
  return {sums[0], sums.tail<3>()};
}

PerRotor Mixer::tilting_part(const Eigen::Vector3d& torque_B_Nm) const {
  const PerRotor part = to_rotors_.col(1) * torque_B_Nm.x() + to_rotors_.col(2) * torque_B_Nm.y();
  const double span = part.maxCoeff() - part.minCoeff();
  return part * std::min(1.0, (greatest_N_ - least_N_) / std::max(span, 1e-9));
}

// The thrust nearest to the wanted one with least ≤ tilting + c T ≤ greatest for every rotor.
double Mixer::thrust_that_fits(double wanted_N, const PerRotor& tilting_N) const {
  const Eigen::Array4d c = to_rotors_.col(0).array();
  const double low = ((least_N_ - tilting_N.array()) / c).maxCoeff();
  const double high = ((greatest_N_ - tilting_N.array()) / c).minCoeff();
  return low <= high ? std::clamp(wanted_N, low, high) : 0.5 * (low + high);
}

// The largest λ in [0, 1] with least ≤ base + λ extra ≤ greatest for every rotor.
double Mixer::share_that_fits(const PerRotor& base_N, const PerRotor& extra_N) const {
  double share = 1.0;
  for (int i = 0; i < kRotors; ++i) {
    const double room = extra_N[i] > 0.0 ? greatest_N_ - base_N[i] : base_N[i] - least_N_;
    const double need = std::abs(extra_N[i]);
    if (need > room) share = std::min(share, std::max(room, 0.0) / need);
  }
  return share;
}

}  // namespace lineservo::vehicle
