#include "vehicle/body/wind.h"

#include <cmath>

#include "vehicle/faults.h"

namespace lineservo::vehicle {

ConstantWind::ConstantWind(double speed_m_s, double direction_rad)
    : v_W_(speed_m_s * std::cos(direction_rad), speed_m_s * std::sin(direction_rad), 0.0) {
  Faults faults("wind");
  faults.require_not_negative(speed_m_s, "speed_m_s");
  faults.require(std::isfinite(direction_rad), "direction_rad must be finite");
  faults.throw_if_any();
}

}  // namespace lineservo::vehicle
