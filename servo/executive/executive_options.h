#pragma once

#include "servo/executive/approach.h"
#include "servo/executive/corner.h"
#include "servo/executive/node_tracker.h"
#include "servo/executive/phase.h"
#include "servo/executive/turn_profile.h"
#include "servo/law/dock_law.h"
#include "servo/law/limits.h"

namespace lineservo::servo {

/// Parameters of the executive and of all that it is made of.
struct ExecutiveOptions {
  double speed_m_s = 0.1;
  PhaseOptions phases;
  ApproachOptions approach;
  CornerOptions corner;
  TurnOptions turn;
  DockOptions dock;
  NodeTracker::Options tracker;
  CommandLimits limits;
  double look_ahead_after_s = 3.0;  ///< of phase align: it takes 2 s where the first edge is plain
  double look_ahead_heights = 0.5;  ///< ahead of the marker: half of it stays in view
  int confirm_frames = 2;
  int doubt_frames = 3;  ///< more of them for a node that the plan does not expect
  double leaving_heights =
      0.7;  ///< a node left behind is in view for so far a way, in heights: half the view
  double climb_rate_m_s = 0.4;
  double heading_gain_per_s = 0.5;  ///< for laws that do not steer the heading
  double heading_rate_limit_rad_s = 0.1;
  double blind_share = 0.4;    ///< of the height of flight, below which a node is no guide for landing
  double sink_rate_m_s = 0.2;  ///< from there on
  double touch_down_m = 0.15;  ///< height from which the autopilot lands by itself, just above the gear
  double descent_share = 0.8;  ///< height aimed at on the way down, of that now
  double speed_time_constant_s = 0.5;  ///< over which the speed that counts as rest is averaged
};

}  // namespace lineservo::servo
