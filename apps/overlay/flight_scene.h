#pragma once

#include "apps/flight/mission.h"
#include "apps/overlay/overlay.h"

namespace lineservo::apps {

/// The overlay of a flight, with the map of its floor.
Overlay flight_overlay(const Mission& mission, std::vector<std::string> notes = {});

/// What it shows of a tick.
OverlayScene scene_of(const FlightTick& tick);

}  // namespace lineservo::apps
