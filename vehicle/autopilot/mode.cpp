#include "vehicle/autopilot/mode.h"

namespace lineservo::vehicle {
namespace {

AutopilotMode next_on_ground(AutopilotMode mode, const Situation& s) {
  return may_take_off(s) ? AutopilotMode::tracking : mode;
}

AutopilotMode next_in_flight(AutopilotMode mode, const Situation& s) {
  if (s.land_requested) return AutopilotMode::landing;
  if (may_track(s)) return AutopilotMode::tracking;
  const bool waited = mode == AutopilotMode::braking && s.in_mode_for >= kBrakesFor;
  return waited ? AutopilotMode::landing : AutopilotMode::braking;
}

AutopilotMode next_landing(const Situation& s) {
  if (s.settled_on_ground) return AutopilotMode::landed;
  return !s.land_requested && may_track(s) ? AutopilotMode::tracking : AutopilotMode::landing;
}

}  // namespace

bool may_track(const Situation& s) {
  return s.command_live && s.estimate_fresh && !s.blind;
}

bool may_take_off(const Situation& s) {
  return may_track(s) && s.wants_up;
}

bool motors_run(AutopilotMode mode) {
  return mode != AutopilotMode::idle && mode != AutopilotMode::landed;
}

AutopilotMode next_mode(AutopilotMode mode, const Situation& s) {
  switch (mode) {
    case AutopilotMode::idle:
    case AutopilotMode::landed:
      return next_on_ground(mode, s);
    case AutopilotMode::tracking:
    case AutopilotMode::braking:
      return next_in_flight(mode, s);
    case AutopilotMode::landing:
      return next_landing(s);
  }
  return mode;
}

}  // namespace lineservo::vehicle
