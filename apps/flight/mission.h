#pragma once

#include <functional>

#include "apps/config/flight_request.h"
#include "apps/flight/flight.h"
#include "apps/output/flight_summary.h"
#include "servo/plan/plan.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// A flight made ready: what was asked for, the floor, and the plan that leads over it.
struct Mission {
  FlightRequest request;
  vehicle::Layout floor;
  servo::Plan plan;
};

/// Reads the floor and compiles the plan. Throws InputError or std::invalid_argument: unknown controller,
/// layout or target, no way to it.
Mission prepare(const FlightRequest& request);

/// A flight as it was, and its figures.
struct FlownMission {
  FlightRecord record;
  FlightSummary summary;
};

/// Flies it to the end and says how it went. Several may fly at once, on threads of their own. `progress` as
/// in Flight::run, `on_tick` as in Flight::listen.
FlownMission fly_mission(const Mission& mission,
                         const std::function<bool(const FlightProgress&)>& progress = {},
                         TickListener on_tick = {});

}  // namespace lineservo::apps
