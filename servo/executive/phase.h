#pragma once

#include <optional>
#include <string_view>

#include "servo/executive/junction_matcher.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {

/// What the vehicle is doing. `corner` is a turn that is flown without a stop. `aborted` hovers for a while
/// and then lands; `finished` is the end of the flight. Between two targets of a mission: `look` turns once
/// about itself, `rest` stands on the ground, `relaunch` comes back to the height above the same node.
/// `search` looks for a line or a node that went out of sight.
enum class Phase {
  take_off,
  align,
  follow,
  corner,
  turn,
  dock,
  hover,
  land,
  aborted,
  finished,
  look,
  rest,
  relaunch,
  search
};

std::string_view name(Phase phase);

enum class AbortReason {
  none,
  take_off_failed,
  line_lost,
  node_lost,
  node_overdue,
  node_unexpected,
  turn_failed,
  line_turns_off,
  stuck,
  height_unknown,
  velocity_unknown,
  not_finite,
  out_of_time,
  grounded
};

std::string_view name(AbortReason reason);

/// Tolerances and time limits of the phases.
struct PhaseOptions {
  double height_m = 0.5;
  double height_tolerance_m = 0.03;
  double take_off_limit_s = 15.0;
  double align_angle_rad = 0.026;
  double align_offset_m = 0.02;
  double align_limit_s = 15.0;
  double settle_s = 0.3;          ///< for which a condition must hold
  double line_memory_s = 1.0;     ///< without a line before it counts as lost
  double length_tolerance = 0.2;  ///< of an edge's length, data/README.md
  double length_slack_m = 0.6;    ///< on top: half the view, where a node is told before it is reached
  /// By which the dead reckoning may be off: three times the velocity bias.
  double odometry_drift_m_s = 0.03;
  double dock_distance_m = 0.015;
  double dock_speed_m_s = 0.03;
  double dock_limit_s = 20.0;
  double turn_angle_rad = 0.017;
  double turn_limit_s = 20.0;
  double corner_angle_rad = 0.05;  ///< of the next edge at the end of a corner
  double hover_s = 8.0;
  double abort_hover_s = 3.0;
  bool land = false;                ///< at the end of the mission
  double sensor_memory_s = 1.0;     ///< without a height or a velocity before the vehicle lands
  double not_finite_limit_s = 0.5;  ///< of estimates or a law's commands that are not finite
  double turn_off_limit_s = 1.0;    ///< of a line on a straight edge that leads elsewhere
  double stuck_limit_s = 20.0;
  double endurance_s = 3600.0;      ///< of the battery, since its switching on
  double landing_reserve_s = 15.0;  ///< of it, kept for landing
};

/// All that decides on the phase, gathered anew each tick. What is not known is absent.
struct Situation {
  double phase_s = 0.0;    ///< time in this phase
  double settled_s = 0.0;  ///< time for which the phase's own goal has held
  double height_m = 0.0;
  double line_unseen_s = 0.0;
  std::optional<double> line_angle_rad;
  std::optional<double> line_offset_m;
  double travelled_m = 0.0;  ///< since the last node
  double since_node_s = 0.0;
  const PlanStep* step = nullptr;         ///< what is expected next
  std::optional<NodeSighting> node;       ///< told in this tick
  std::optional<double> node_distance_m;  ///< of the node that is docked on, or of the start marker
  double speed_m_s = 0.0;
  double turn_left_rad = 0.0;
  bool looks_ahead = false;     ///< of the start marker, for the first edge
  bool rounds_corner = false;   ///< the turn that comes can be flown without a stop
  bool past_corner = false;     ///< the arc lies behind
  bool servos_on_node = false;  ///< the law docks; others stop on the confirmed code
  bool on_ground = false;
  double flight_s = 0.0;
  double height_age_s = 0.0, velocity_age_s = 0.0;  ///< for which no sensor has told them
  double not_finite_s = 0.0;                        ///< for which what came in or went out was not finite
  double stuck_s = 0.0;                             ///< for which the vehicle has made no way along the line
  double line_off_s = 0.0;    ///< for which the line has turned off a straight edge's heading
  bool node_puzzles = false;  ///< it is none that the plan or the floor can explain
  double lost_limit_m = 0.0;  ///< beyond being overdue, on which other codes may come
  bool may_search = false;    ///< here, once more
  bool search_is_over = false;
  Phase searched_from = Phase::follow;
  AbortReason given_up = AbortReason::none;
  bool is_last = true;   ///< no target comes after the step
  bool gave_up = false;  ///< the flight was broken off
};

/// Each is one condition of the transition function.
bool at_height(const Situation& s, const PhaseOptions& o);
/// On the line's heading; a law that docks also above the start marker or, without one, on the line.
bool aligned(const Situation& s, const PhaseOptions& o);
bool docked(const Situation& s, const PhaseOptions& o);
/// At height, and a law that docks above its node.
bool relaunched(const Situation& s, const PhaseOptions& o);
/// By the next line's angle; a law that turns where its code came may not see that line yet and goes by the
/// gyro.
bool turned(const Situation& s, const PhaseOptions& o);
/// Past the arc and on the next line's heading; the law that follows lines does the rest.
bool cornered(const Situation& s, const PhaseOptions& o);
bool expected(const NodeSighting& node, const PlanStep& step);
/// The line or node that is searched for is in sight.
bool found(const Situation& s, const PhaseOptions& o);
/// The expected code did not come within the possible distance.
bool overdue(const Situation& s, const PhaseOptions& o);
/// A node came where none can be yet.
bool too_early(const Situation& s, const PhaseOptions& o);

/// Whether the phase's own goal holds in this tick; `settled_s` counts for how long it has.
bool goal_holds(Phase phase, const Situation& s, const PhaseOptions& o);

/// Why the flight cannot go on, or none.
AbortReason abort_reason(Phase phase, const Situation& s, const PhaseOptions& o);

/// The phase that follows. Pure: the whole state machine.
Phase next(Phase phase, const Situation& s, const PhaseOptions& o);

}  // namespace lineservo::servo
