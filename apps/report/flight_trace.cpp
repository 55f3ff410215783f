#include "apps/report/flight_trace.h"

#include <algorithm>
#include <cmath>

#include "apps/report/floor_json.h"
#include "apps/report/tick_rows.h"

namespace lineservo::apps {
namespace {

/// −1 where there is no error, so that any error goes before it.
double size_of_error(const TracePoint& point) {
  return std::isnan(point.error_m) ? -1.0 : std::abs(point.error_m);
}

bool errs_less(const TracePoint& a, const TracePoint& b) {
  return size_of_error(a) < size_of_error(b);
}

}  // namespace

FlightTrace trace_of(const Mission& mission, const FlownMission& flown) {
  const RouteTruth route = route_truth(mission.floor, mission.plan);
  FlightTrace trace{floor_json(mission.floor), route_json(route), {}, {}};
  for (const TickRow& row : tick_rows(flown.record, route, flown.summary.junctions)) {
    const TickRecord& tick = *row.tick;
    const double t_s = vehicle::seconds(tick.t);
    trace.points.push_back({t_s, tick.now.p_WB.x(), tick.now.p_WB.y(), row.error_m, row.leg});
    if (tick.has_frame) trace.codes.push_back({t_s, tick.code.raw, row.true_code});
  }
  return trace;
}

std::vector<TracePoint> thinned(const std::vector<TracePoint>& points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<TracePoint> kept;
  for (std::size_t k = 0; k < most; ++k) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(k * points.size() / most);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>((k + 1) * points.size() / most);
    kept.push_back(*std::max_element(begin, end, errs_less));
  }
  return kept;
}

}  // namespace lineservo::apps
