#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "apps/flight/mission.h"

namespace lineservo::apps {

/// Where a flight was at one control tick.
struct TracePoint {
  double t_s, x_m, y_m;
  double error_m;  ///< NaN where it does not count
  int leg;         ///< −1 there
};

/// What the recogniser said of one frame, and the true code; −1 where that is not scored.
struct TracedCode {
  double t_s;
  features::JunctionCode raw;
  int true_code;
};

/// What a comparison keeps of a flight to draw it.
struct FlightTrace {
  nlohmann::ordered_json floor, route;  ///< as in the report of a flight
  std::vector<TracePoint> points;
  std::vector<TracedCode> codes;
};

FlightTrace trace_of(const Mission& mission, const FlownMission& flown);

/// At most so many points: of each stretch the one with the largest error.
std::vector<TracePoint> thinned(const std::vector<TracePoint>& points, std::size_t most);

}  // namespace lineservo::apps
