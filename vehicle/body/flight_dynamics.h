#pragma once

#include "vehicle/body/aerodynamics.h"
#include "vehicle/body/motors.h"
#include "vehicle/body/rigid_body.h"
#include "vehicle/body/wind.h"

namespace lineservo::vehicle {

/// From rotor commands to motion: motors, air, rigid body.
class FlightDynamics {
 public:
  FlightDynamics(const AirframeParameters& airframe, const BodyState& start);

  /// One kPhysicsStep with these rotor commands in air that moves so.
  void step(const PerRotor& commanded_rad_s, const Eigen::Vector3d& wind_W);

  const BodyState& state() const { return body_.state(); }
  const GroundContact& ground_contact() const { return body_.ground_contact(); }
  const PerRotor& rotor_speeds_rad_s() const { return motors_.speeds_rad_s(); }

 private:
  Motors motors_;
  Aerodynamics air_;
  RigidBody body_;
};

}  // namespace lineservo::vehicle
