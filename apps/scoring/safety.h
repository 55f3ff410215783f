#pragma once

#include <string>

#include "apps/flight/flight_record.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// Further than this from paint that the layout knows, no flight may come.
inline constexpr double kCorridor_m = 1.0;

/// How a flight ended, whatever became of its mission.
struct Safety {
  std::string ends;               ///< "hover", "ground", "air" (cut off in flight) or "crash"
  double paint_distance_m = 0.0;  ///< largest, of the true body from the layout's paint
  std::string reason;             ///< why it was broken off; empty when it was not

  bool is_safe() const { return (ends == "hover" || ends == "ground") && paint_distance_m <= kCorridor_m; }
};

Safety assess_safety(const FlightRecord& record, const vehicle::Layout& floor);

}  // namespace lineservo::apps
