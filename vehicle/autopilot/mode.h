#pragma once

#include "vehicle/time.h"

namespace lineservo::vehicle {

/// What the autopilot is doing.
enum class AutopilotMode { idle, tracking, braking, landing, landed };

/// After this long without anything to do it lands.
inline constexpr Time kBrakesFor = std::chrono::seconds(5);

/// What decides on the mode.
struct Situation {
  bool command_live = false;    ///< a velocity or attitude command that has not run out
  bool wants_up = false;        ///< and it asks to climb
  bool land_requested = false;  ///< the newest command was to land
  bool estimate_fresh = true;
  bool blind = false;  ///< travelled too far since paint was in sight
  bool settled_on_ground = false;
  Time in_mode_for{0};
};

bool may_track(const Situation& situation);
bool may_take_off(const Situation& situation);
bool motors_run(AutopilotMode mode);

AutopilotMode next_mode(AutopilotMode mode, const Situation& situation);

}  // namespace lineservo::vehicle
