#pragma once

#include <Eigen/Core>
#include <array>

namespace lineservo::vehicle {

/// Where a rotor sits in B and which way it turns, seen from above.
struct RotorPlacement {
  enum class Spin { counter_clockwise, clockwise };
  double x_m = 0.0;
  double y_m = 0.0;
  Spin spin = Spin::counter_clockwise;

  /// +1 counter-clockwise, −1 clockwise.
  double spin_sign() const { return spin == Spin::counter_clockwise ? 1.0 : -1.0; }
};

inline constexpr double kGravity_m_s2 = 9.81;
inline constexpr int kRotors = 4;
/// A value for each rotor, in the order of AirframeParameters::rotors.
using PerRotor = Eigen::Vector4d;

/// A quadrotor's body and rotors. The defaults are the 3DR Iris.
struct AirframeParameters {
  double mass_kg = 1.5;
  Eigen::Vector3d inertia_kg_m2{0.029125, 0.029125, 0.055225};  ///< about the axes of B
  std::array<RotorPlacement, kRotors> rotors{{
      {0.13, -0.22, RotorPlacement::Spin::counter_clockwise},  // front right
      {-0.13, 0.20, RotorPlacement::Spin::counter_clockwise},  // rear left
      {0.13, 0.22, RotorPlacement::Spin::clockwise},           // front left
      {-0.13, -0.20, RotorPlacement::Spin::clockwise},         // rear right
  }};
  double thrust_coefficient_N_s2 = 5.84e-6;  ///< thrust = k ω²
  double moment_coefficient_m = 0.06;        ///< reaction torque over thrust
  double max_rotor_speed_rad_s = 1100.0;
  double rotor_drag_N_per_rad_s_m_s = 1.75e-4;
  double motor_lag_up_s = 0.0125;
  double motor_lag_down_s = 0.025;
  double rotor_radius_m = 0.128;
  double body_drag_area_m2 = 0.02;  ///< C_d A
  /// A heavier body than the one that the autopilot was made for: on its mass and its inertia.
  double load_factor = 1.0;
  /// Weak motors: on the thrust and the reaction torque of each rotor; the autopilot does not know.
  PerRotor thrust_factors = PerRotor::Ones();
  double gear_height_m = 0.10;  ///< of the body origin above the floor when landed
  Eigen::Vector3d collision_half_extents_m{0.235, 0.235, 0.055};  ///< the box stands on the floor when landed

  /// Throws one std::invalid_argument that lists every fault.
  void validate() const;

  /// Thrust along z_B and the three moments from the rotors' thrusts: (T, M_x, M_y, M_z) = A f.
  Eigen::Matrix4d allocation() const;

  /// With the load on: what flies. The autopilot goes by the bare airframe.
  AirframeParameters loaded() const;

  double weight_N() const { return mass_kg * kGravity_m_s2; }
  double max_rotor_thrust_N() const {
    return thrust_coefficient_N_s2 * max_rotor_speed_rad_s * max_rotor_speed_rad_s;
  }
  /// Every rotor's speed when together they carry the weight.
  double hover_speed_rad_s() const;
  /// Distance of neighbouring rotors along the rim, on average, and of opposite ones.
  double rotor_spacing_m() const;
  double rotor_diagonal_m() const;
};

}  // namespace lineservo::vehicle
