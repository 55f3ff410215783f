#include "vehicle/body/aerodynamics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lineservo::vehicle {
namespace {

/// z/√((b² + 4z²)³): the image of a source at the horizontal distance b below the floor.
double image_source(double distance_m, double height_m) {
  const double r2 = distance_m * distance_m + 4.0 * height_m * height_m;
  return height_m / (r2 * std::sqrt(r2));
}

}  // namespace

Aerodynamics::Aerodynamics(const AirframeParameters& airframe)
    : airframe_(airframe), spacing_m_(airframe.rotor_spacing_m()), diagonal_m_(airframe.rotor_diagonal_m()) {}

Wrench Aerodynamics::wrench(const PerRotor& rotor_speeds_rad_s, const AirMotion& motion) const {
  Wrench sum;
  for (int i = 0; i < kRotors; ++i) sum += rotor_wrench(i, rotor_speeds_rad_s[i], motion);
  sum.force_B_N += body_drag_B(motion.v_air_B);
  return sum;
}

// Sanchez-Cuevas, Heredia and Ollero, "Characterization of the aerodynamic ground effect and its influence in
// multirotor control" (2017): with R the rotor radius, d and b the distances of neighbouring and of opposite
// rotors, and K_b = 2 for the fountain under the body,
//   T/T∞ = 1 / (1 − (R/4z)² − R² z/√((d²+4z²)³) − (R²/2) z/√((2d²+4z²)³) − 2 R² K_b z/√((b²+4z²)³)).
// For d, b → ∞ it is Cheeseman and Bennett's single rotor, which holds down to z = R/2: held there below.
double Aerodynamics::ground_effect(double rotor_height_m) const {
  constexpr double kFountain = 2.0;
  const double R = airframe_.rotor_radius_m;
  const double z = std::max(rotor_height_m, 0.5 * R);
  const double own = (R / (4.0 * z)) * (R / (4.0 * z));
  const double neighbours = image_source(spacing_m_, z) + 0.5 * image_source(std::sqrt(2.0) * spacing_m_, z);
  const double body = 2.0 * kFountain * image_source(diagonal_m_, z);
  return 1.0 / (1.0 - own - R * R * (neighbours + body));
}

// Thrust T = k ω² along z_B; reaction torque −c T about it for a rotor that turns counter-clockwise; drag
// −c_d ω v⊥ with v⊥ the part of the rotor's motion through the air across its axis.
Wrench Aerodynamics::rotor_wrench(int rotor, double speed_rad_s, const AirMotion& motion) const {
  const RotorPlacement& place = airframe_.rotors[static_cast<std::size_t>(rotor)];
  const Eigen::Vector3d p_B(place.x_m, place.y_m, 0.0);
  const double free_thrust_N =
      airframe_.thrust_factors[rotor] * airframe_.thrust_coefficient_N_s2 * speed_rad_s * speed_rad_s;
  const double thrust_N = free_thrust_N * ground_effect(motion.height_m + motion.up_B.dot(p_B));
  const Eigen::Vector3d v_rotor_B = motion.v_air_B + motion.w_B.cross(p_B);
  const double drag = airframe_.rotor_drag_N_per_rad_s_m_s * speed_rad_s;
  Wrench wrench;
  wrench.force_B_N << -drag * v_rotor_B.x(), -drag * v_rotor_B.y(), thrust_N;
  wrench.torque_B_Nm = p_B.cross(wrench.force_B_N);
  wrench.torque_B_Nm.z() -= place.spin_sign() * airframe_.moment_coefficient_m * free_thrust_N;
  return wrench;
}

// F = −½ ρ C_d A |v| v
Eigen::Vector3d Aerodynamics::body_drag_B(const Eigen::Vector3d& v_air_B) const {
  return -0.5 * kAirDensity_kg_m3 * airframe_.body_drag_area_m2 * v_air_B.norm() * v_air_B;
}

}  // namespace lineservo::vehicle
