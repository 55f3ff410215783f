#pragma once

#include <string>

#include "apps/flight/mission.h"
#include "tests/apps/test_floors.h"

namespace lineservo::apps::testing {

/// A request under conditions that ship.
inline FlightRequest request_for(const std::string& instruction, const std::string& conditions,
                                 std::uint64_t seed = 1) {
  FlightRequest request;
  apply_conditions(request, conditions);
  request.instruction = instruction;
  request.seed = seed;
  return request;
}

using Flown = FlownMission;

/// Flies a plan over a floor that it need not have been compiled from. `planned` is the floor of the plan.
inline Flown fly(const FlightRequest& request, const vehicle::Layout& planned, const vehicle::Layout& floor) {
  return fly_mission({request, floor, plan_on(planned, request.instruction)});
}

inline Flown fly(const FlightRequest& request) {
  return fly_mission(prepare(request));
}

/// Why a flight did not go as hoped, for the message of a test.
inline std::string story(const Flown& flown) {
  std::string text = flown.summary.outcome + " (" + std::string(servo::name(flown.record.abort_reason)) + ")";
  for (const EventRecord& event : flown.record.events)
    text += "\n  " + std::to_string(vehicle::seconds(event.t)) + " " + event.kind + ": " + event.detail;
  return text;
}

}  // namespace lineservo::apps::testing
