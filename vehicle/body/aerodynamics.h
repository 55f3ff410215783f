#pragma once

#include "vehicle/body/airframe.h"
#include "vehicle/body/wrench.h"

namespace lineservo::vehicle {

inline constexpr double kAirDensity_kg_m3 = 1.225;

/// How the body moves through the air.
struct AirMotion {
  Eigen::Vector3d v_air_B = Eigen::Vector3d::Zero();  ///< of the body origin relative to the air, in B
  Eigen::Vector3d w_B = Eigen::Vector3d::Zero();
  /// The world's vertical in B, and the origin's height: where each rotor is above the floor.
  Eigen::Vector3d up_B = Eigen::Vector3d::UnitZ();
  double height_m = 1e3;
};

/// The forces of air on the airframe.
class Aerodynamics {
 public:
  explicit Aerodynamics(const AirframeParameters& airframe);

  /// All of it: rotors and body.
  Wrench wrench(const PerRotor& rotor_speeds_rad_s, const AirMotion& motion) const;

  /// Thrust near the floor over thrust far from it, for a rotor at this height.
  double ground_effect(double rotor_height_m) const;

 private:
  Wrench rotor_wrench(int rotor, double speed_rad_s, const AirMotion& motion) const;
  Eigen::Vector3d body_drag_B(const Eigen::Vector3d& v_air_B) const;

  AirframeParameters airframe_;
  double spacing_m_, diagonal_m_;
};

}  // namespace lineservo::vehicle
