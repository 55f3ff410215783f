#include "vehicle/setpoint.h"

#include <cmath>

namespace lineservo::vehicle {
namespace {

struct AllFinite {
  bool operator()(const LandSetpoint&) const { return true; }
  bool operator()(const VelocitySetpoint& s) const {
    return s.v_H_m_s.allFinite() && std::isfinite(s.yaw_rate_rad_s);
  }
  bool operator()(const AttitudeSetpoint& s) const {
    return std::isfinite(s.roll_rad) && std::isfinite(s.pitch_rad) && std::isfinite(s.yaw_rate_rad_s) &&
           std::isfinite(s.height_m);
  }
};

}  // namespace

bool is_finite(const Setpoint& setpoint) {
  return std::visit(AllFinite{}, setpoint);
}

}  // namespace lineservo::vehicle
