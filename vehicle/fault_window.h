#pragma once

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// When something goes wrong; never while it lasts 0 s.
struct FaultWindow {
  double start_s = 0.0;
  double duration_s = 0.0;

  bool is_set() const { return duration_s > 0.0; }
  bool holds(Time t) const {
    const double t_s = seconds(t);
    return t_s >= start_s && t_s < start_s + duration_s;
  }
};

}  // namespace lineservo::vehicle
