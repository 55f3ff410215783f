#pragma once

#include <limits>
#include <vector>

#include "apps/flight/flight_record.h"
#include "apps/scoring/junction_score.h"
#include "apps/scoring/route_truth.h"

namespace lineservo::apps {

/// A control tick with what only the truth tells about it; NaN and −1 where it does not apply.
struct TickRow {
  const TickRecord* tick;
  double error_m = std::numeric_limits<double>::quiet_NaN();  ///< positive to the left of travel
  int leg = -1;
  bool turning = false;
  int true_code = -1;  ///< of a scored frame; where two count, the one that was seen
};

std::vector<TickRow> tick_rows(const FlightRecord& record, const RouteTruth& route,
                               const JunctionScore& junctions);

}  // namespace lineservo::apps
