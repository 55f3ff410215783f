#include "vehicle/autopilot/gains.h"

#include <algorithm>

#include "vehicle/sensors/sensor_parameters.h"

namespace lineservo::vehicle {
namespace {

// Rotors at the distances r drag with Σ c_d ω r² on the yaw rate.
double yaw_drag(const AirframeParameters& a) {
  double sum_r2 = 0.0;
  for (const RotorPlacement& r : a.rotors) sum_r2 += r.x_m * r.x_m + r.y_m * r.y_m;
  return a.rotor_drag_N_per_rad_s_m_s * a.hover_speed_rad_s() * sum_r2 / a.inertia_kg_m2.z();
}

}  // namespace

// With a lag τ in the plant and the gain k, the rate loop is τ s² + s + k: damping 1/(2√(kτ)), so kτ = 0.4
// damps with 0.79. Half a period of hold and half a period of sampling add to the lag.
Gains::Gains(const AirframeParameters& a)
    : rotor_lag_s(std::min(a.motor_lag_up_s, a.motor_lag_down_s)),
      rate_per_s(0.4 / (rotor_lag_s + seconds(kInertialPeriod))),
      rate_integral_per_s2(rate_per_s * rate_per_s / 50.0),
      attitude_per_s(rate_per_s / 2.5),
      attitude_lag_s(1.0 / attitude_per_s + 0.5 * seconds(kInertialPeriod)),
      velocity_per_s(1.0 / (5.0 * attitude_lag_s)),
      acceleration_gain(0.5),
      push_lag_s(rotor_lag_s + seconds(kInertialPeriod)),
      velocity_bandwidth_per_s(0.9 / attitude_lag_s),
      climb_per_s(0.1 / (rotor_lag_s + seconds(kInertialPeriod))),
      climb_integral_per_s2(climb_per_s * climb_per_s / 5.0),
      climb_bandwidth_per_s(climb_per_s),
      yaw_acceleration_rad_s2(0.3 * a.moment_coefficient_m * a.weight_N() / a.inertia_kg_m2.z()),
      drag_per_s(kRotors * a.rotor_drag_N_per_rad_s_m_s * a.hover_speed_rad_s() / a.mass_kg),
      yaw_drag_per_s(yaw_drag(a)) {}

}  // namespace lineservo::vehicle
