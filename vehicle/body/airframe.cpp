#include "vehicle/body/airframe.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "vehicle/faults.h"

namespace lineservo::vehicle {
namespace {

/// The distances between all pairs of rotors, shortest first: four neighbours, then two diagonals.
std::array<double, 6> rotor_distances_m(const AirframeParameters& airframe) {
  std::array<double, 6> distances{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < kRotors; ++i) {
    for (std::size_t j = i + 1; j < kRotors; ++j) {
      distances[n++] = std::hypot(airframe.rotors[i].x_m - airframe.rotors[j].x_m,
                                  airframe.rotors[i].y_m - airframe.rotors[j].y_m);
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

void check_body(const AirframeParameters& a, Faults& faults) {
  faults.require_positive(a.mass_kg, "mass_kg");
  const Eigen::Vector3d& I = a.inertia_kg_m2;
  faults.require(I.allFinite() && I.minCoeff() > 0.0 && 2.0 * I.maxCoeff() <= I.sum() * (1.0 + 1e-9),
                 "inertia_kg_m2 must be positive, no element above the sum of the other two");
  faults.require_not_negative(a.body_drag_area_m2, "body_drag_area_m2");
  faults.require_positive(a.load_factor, "load_factor");
  faults.require_positive(a.gear_height_m, "gear_height_m");
  faults.require(a.collision_half_extents_m.allFinite() && a.collision_half_extents_m.minCoeff() > 0.0,
                 "collision_half_extents_m must be positive");
}

/// Every rotor carries some of the weight in hover, and any moment can be made.
bool can_hover_and_turn(const AirframeParameters& a) {
  const Eigen::FullPivLU<Eigen::Matrix4d> allocation(a.allocation());
  return allocation.isInvertible() && allocation.solve(Eigen::Vector4d::UnitX()).eval().minCoeff() > 0.0;
}

void check_rotor_places(const AirframeParameters& a, Faults& faults) {
  double spins = 0.0;
  bool finite = true;
  for (const RotorPlacement& rotor : a.rotors) {
    spins += rotor.spin_sign();
    finite = finite && std::isfinite(rotor.x_m) && std::isfinite(rotor.y_m);
  }
  faults.require(spins == 0.0, "rotors must turn two clockwise and two counter-clockwise");
  faults.require(finite, "rotors must have finite places");
  faults.require(!finite || rotor_distances_m(a).front() >= 2.0 * a.rotor_radius_m,
                 "rotors must not overlap: rotor_radius_m at most half of their least distance");
  faults.require(!finite || can_hover_and_turn(a),
                 "rotors must surround the centre of mass and be able to turn the vehicle about every axis");
}

void check_rotors(const AirframeParameters& a, Faults& faults) {
  check_rotor_places(a, faults);
  faults.require_positive(a.thrust_coefficient_N_s2, "thrust_coefficient_N_s2");
  faults.require_positive(a.moment_coefficient_m, "moment_coefficient_m");
  faults.require_positive(a.max_rotor_speed_rad_s, "max_rotor_speed_rad_s");
  faults.require_not_negative(a.rotor_drag_N_per_rad_s_m_s, "rotor_drag_N_per_rad_s_m_s");
  faults.require_positive(a.motor_lag_up_s, "motor_lag_up_s");
  faults.require_positive(a.motor_lag_down_s, "motor_lag_down_s");
  faults.require_positive(a.rotor_radius_m, "rotor_radius_m");
  faults.require(a.thrust_factors.allFinite() && a.thrust_factors.minCoeff() > 0.0,
                 "thrust_factors must be finite and above 0");
  faults.require(a.thrust_factors.sum() * a.max_rotor_thrust_N() > 1.2 * a.load_factor * a.weight_N(),
                 "full thrust must be above 1.2 times the weight");
}

}  // namespace

void AirframeParameters::validate() const {
  Faults faults("airframe");
  check_body(*this, faults);
  check_rotors(*this, faults);
  faults.throw_if_any();
}

// (T, M_x, M_y, M_z) = Σ f (1, y, −x, −spin c)
Eigen::Matrix4d AirframeParameters::allocation() const {
  Eigen::Matrix4d A;
  for (int i = 0; i < kRotors; ++i) {
    const RotorPlacement& r = rotors[static_cast<std::size_t>(i)];
    A.col(i) << 1.0, r.y_m, -r.x_m, -r.spin_sign() * moment_coefficient_m;
  }
  return A;
}

AirframeParameters AirframeParameters::loaded() const {
  AirframeParameters flown = *this;
  flown.mass_kg *= load_factor;
  flown.inertia_kg_m2 *= load_factor;
  flown.load_factor = 1.0;
  return flown;
}

double AirframeParameters::hover_speed_rad_s() const {
  return std::sqrt(weight_N() / (kRotors * thrust_coefficient_N_s2));
}

double AirframeParameters::rotor_spacing_m() const {
  const auto d = rotor_distances_m(*this);
  return (d[0] + d[1] + d[2] + d[3]) / 4.0;
}

double AirframeParameters::rotor_diagonal_m() const {
  const auto d = rotor_distances_m(*this);
  return (d[4] + d[5]) / 2.0;
}

}  // namespace lineservo::vehicle
