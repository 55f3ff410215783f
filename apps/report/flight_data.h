#pragma once

#include <string>
#include <vector>

#include "apps/flight/mission.h"
#include "apps/report/film_strip.h"

namespace lineservo::apps {

/// What the report of a flight shows, as JSON: the summary, the published figures, floor and way, events, and
/// a column for each quantity with one number a control tick, the same as in flight.csv.
std::string flight_data(const Mission& mission, const FlightRecord& record, const FlightSummary& summary,
                        const std::vector<Thumbnail>& thumbnails = {});

}  // namespace lineservo::apps
