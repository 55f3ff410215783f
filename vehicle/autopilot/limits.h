#pragma once

#include "vehicle/autopilot/options.h"
#include "vehicle/estimate.h"
#include "vehicle/setpoint.h"

namespace lineservo::vehicle {

/// How fast a height error is worked off.
inline constexpr double kHeightGain_per_s = 2.0;

/// The climb rate that leads to a height, within the limit.
double climb_rate_to(double height_m, const Estimate& estimate, const SafetyLimits& limits);

/// The set-point brought within the limits; above the greatest height it descends.
VelocitySetpoint limited(VelocitySetpoint setpoint, const Estimate& estimate, const SafetyLimits& limits);
AttitudeSetpoint limited(AttitudeSetpoint setpoint, const SafetyLimits& limits);

/// An acceleration without the part that would drive the vehicle beyond its greatest speed:
/// a·v̂ ≤ gain (v_max − |v|).
Eigen::Vector2d speed_limited(const Eigen::Vector2d& a_H_m_s2, const Estimate& estimate, double gain_per_s,
                              const SafetyLimits& limits);

/// The vector, no longer than this.
Eigen::Vector2d shortened(const Eigen::Vector2d& v, double longest);

}  // namespace lineservo::vehicle
