#pragma once

#include <nlohmann/json.hpp>

#include "apps/scoring/route_truth.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// What the map of a report shows of a floor: nodes, lines as polylines with width and colour, markers.
nlohmann::ordered_json floor_json(const vehicle::Layout& floor);

/// The true way: the centreline of each leg as a polyline.
nlohmann::ordered_json route_json(const RouteTruth& route);

}  // namespace lineservo::apps
