#include "vehicle/body/flight_dynamics.h"

namespace lineservo::vehicle {
namespace {

AirMotion air_motion(const BodyState& state, const Eigen::Vector3d& wind_W) {
  const Eigen::Quaterniond q_BW = state.q_WB.conjugate();
  AirMotion motion;
  motion.v_air_B = q_BW * (state.v_W - wind_W);
  motion.w_B = state.w_B;
  motion.up_B = q_BW * Eigen::Vector3d::UnitZ();
  motion.height_m = state.p_WB.z();
  return motion;
}

}  // namespace

FlightDynamics::FlightDynamics(const AirframeParameters& airframe, const BodyState& start)
    : motors_(airframe, seconds(kPhysicsStep)), air_(airframe), body_(airframe, start) {}

void FlightDynamics::step(const PerRotor& commanded_rad_s, const Eigen::Vector3d& wind_W) {
  motors_.step(commanded_rad_s);
  const AirMotion motion = air_motion(body_.mid_step_state(), wind_W);
  body_.step(air_.wrench(motors_.mid_step_speeds_rad_s(), motion));
}

}  // namespace lineservo::vehicle
