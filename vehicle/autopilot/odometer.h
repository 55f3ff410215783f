#pragma once

#include "vehicle/estimate.h"

namespace lineservo::vehicle {

/// The distance travelled, by the estimated speed, since paint was last in sight.
class BlindOdometer {
 public:
  void travel(const Estimate& estimate, double period_s);
  /// Paint was in the picture taken at t. What was travelled since then counts on.
  void paint_sighted(Time t, const Estimate& now);
  void reset() { travelled_m_ = 0.0; }
  double travelled_m() const { return travelled_m_; }

 private:
  double travelled_m_ = 0.0;
  Time last_sighting_{-1};
};

}  // namespace lineservo::vehicle
