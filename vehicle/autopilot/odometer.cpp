#include "vehicle/autopilot/odometer.h"

#include <algorithm>

namespace lineservo::vehicle {

void BlindOdometer::travel(const Estimate& estimate, double period_s) {
  travelled_m_ += period_s * estimate.v_H_m_s.head<2>().norm();
}

void BlindOdometer::paint_sighted(Time t, const Estimate& now) {
  if (t <= last_sighting_) return;
  last_sighting_ = t;
  const double since_s = std::max(seconds(now.stamp - t), 0.0);
  travelled_m_ = std::min(travelled_m_, since_s * now.v_H_m_s.head<2>().norm());
}

}  // namespace lineservo::vehicle
