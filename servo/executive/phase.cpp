#include "servo/executive/phase.h"

#include <cmath>

namespace lineservo::servo {
namespace {

bool settled(const Situation& s, const PhaseOptions& o) {
  return s.settled_s >= o.settle_s;
}

Phase after_node(const Situation& s) {
  if (!s.node || !s.step) return Phase::follow;
  switch (s.step->manoeuvre) {
    case Manoeuvre::go_straight:
      return Phase::follow;
    case Manoeuvre::turn:
      if (!s.servos_on_node) return Phase::turn;
      return s.rounds_corner ? Phase::corner : Phase::dock;
    case Manoeuvre::hover:
      return s.servos_on_node ? Phase::dock : Phase::hover;
  }
  return Phase::aborted;
}

Phase after_docking(const Situation& s) {
  return s.step && s.step->manoeuvre == Manoeuvre::turn ? Phase::turn : Phase::hover;
}

double hover_time_s(const Situation& s, const PhaseOptions& o) {
  return s.step ? s.step->stop.hover_s.value_or(o.hover_s) : o.hover_s;
}

Phase after_looking(const Situation& s, const PhaseOptions& o) {
  const bool lands = (s.step && s.step->stop.land) || (s.is_last && o.land);
  if (lands) return Phase::land;
  return s.is_last ? Phase::finished : Phase::turn;
}

Phase after_hovering(const Situation& s, const PhaseOptions& o) {
  return s.step && s.step->stop.look ? Phase::look : after_looking(s, o);
}

double turn_limit_s(Phase phase, const PhaseOptions& o) {
  return phase == Phase::look ? 2.0 * o.turn_limit_s : o.turn_limit_s;
}

bool needs_line(Phase phase) {
  return phase == Phase::align || phase == Phase::follow;
}

bool is_out_of_sight(Phase phase, const Situation& s, const PhaseOptions& o) {
  if (phase == Phase::dock) return !s.node_distance_m;
  return needs_line(phase) && s.line_unseen_s > o.line_memory_s;
}

bool has_ended(Phase phase) {
  return phase == Phase::land || phase == Phase::aborted || phase == Phase::finished;
}

/// Beyond this no other code can come either.
bool lost(const Situation& s, const PhaseOptions& o) {
  Situation shorter = s;
  shorter.travelled_m -= s.lost_limit_m;
  return overdue(shorter, o);
}

/// What ends a flight in whatever phase it is.
AbortReason abort_reason_of_vehicle(Phase phase, const Situation& s, const PhaseOptions& o) {
  if (s.not_finite_s > o.not_finite_limit_s) return AbortReason::not_finite;
  if (s.height_age_s > o.sensor_memory_s) return AbortReason::height_unknown;
  if (s.velocity_age_s > o.sensor_memory_s) return AbortReason::velocity_unknown;
  if (s.flight_s > o.endurance_s - o.landing_reserve_s) return AbortReason::out_of_time;
  const bool may_stand = phase == Phase::take_off || phase == Phase::rest || phase == Phase::relaunch;
  if (s.on_ground && !may_stand) return AbortReason::grounded;
  return AbortReason::none;
}

/// A flight that cannot stay up for long, or knows too little of itself, lands at once.
double hover_before_landing_s(const Situation& s, const PhaseOptions& o) {
  return s.given_up >= AbortReason::height_unknown ? 0.0 : o.abort_hover_s;
}

}  // namespace

std::string_view name(Phase phase) {
  switch (phase) {
    case Phase::take_off:
      return "take-off";
    case Phase::align:
      return "align";
    case Phase::follow:
      return "follow";
    case Phase::corner:
      return "corner";
    case Phase::turn:
      return "turn";
    case Phase::dock:
      return "dock";
    case Phase::hover:
      return "hover";
    case Phase::land:
      return "land";
    case Phase::aborted:
      return "aborted";
    case Phase::finished:
      return "finished";
    case Phase::look:
      return "look";
    case Phase::rest:
      return "rest";
    case Phase::relaunch:
      return "relaunch";
    case Phase::search:
      return "search";
  }
  return "?";
}

std::string_view name(AbortReason reason) {
  switch (reason) {
    case AbortReason::none:
      return "none";
    case AbortReason::take_off_failed:
      return "the height was not reached";
    case AbortReason::line_lost:
      return "no line in view";
    case AbortReason::node_lost:
      return "the node to dock on was lost";
    case AbortReason::node_overdue:
      return "the expected code did not come within the possible distance";
    case AbortReason::node_unexpected:
      return "a node came that the plan does not expect here";
    case AbortReason::turn_failed:
      return "the turn did not end on a line";
    case AbortReason::line_turns_off:
      return "the line turns off where the edge is straight";
    case AbortReason::stuck:
      return "no way is made along the line";
    case AbortReason::height_unknown:
      return "no sensor tells the height";
    case AbortReason::velocity_unknown:
      return "no sensor tells the velocity";
    case AbortReason::not_finite:
      return "numbers that are not finite";
    case AbortReason::out_of_time:
      return "the battery's time runs out";
    case AbortReason::grounded:
      return "the autopilot has landed";
  }
  return "?";
}

bool at_height(const Situation& s, const PhaseOptions& o) {
  return std::abs(s.height_m - o.height_m) < o.height_tolerance_m;
}

bool aligned(const Situation& s, const PhaseOptions& o) {
  if (!s.line_angle_rad || std::abs(*s.line_angle_rad) > o.align_angle_rad) return false;
  const bool by_marker = s.node_distance_m && !s.looks_ahead;
  const std::optional<double>& off_m = by_marker ? s.node_distance_m : s.line_offset_m;
  return !s.servos_on_node || (off_m && std::abs(*off_m) < o.align_offset_m);
}

bool docked(const Situation& s, const PhaseOptions& o) {
  return s.node_distance_m && *s.node_distance_m < o.dock_distance_m && s.speed_m_s < o.dock_speed_m_s;
}

bool relaunched(const Situation& s, const PhaseOptions& o) {
  return at_height(s, o) && (docked(s, o) || !s.servos_on_node);
}

bool turned(const Situation& s, const PhaseOptions& o) {
  const bool on_line = s.line_angle_rad || !s.servos_on_node;
  return on_line && std::abs(s.turn_left_rad) < o.turn_angle_rad;
}

bool cornered(const Situation& s, const PhaseOptions& o) {
  return s.past_corner && s.line_angle_rad && std::abs(s.turn_left_rad) < o.corner_angle_rad;
}

bool expected(const NodeSighting& node, const PlanStep& step) {
  return matches(node, step.expected);
}

bool found(const Situation& s, const PhaseOptions&) {
  return s.searched_from == Phase::dock ? s.node_distance_m.has_value() : s.line_angle_rad.has_value();
}

bool overdue(const Situation& s, const PhaseOptions& o) {
  const double at_least_m = s.travelled_m - o.odometry_drift_m_s * s.since_node_s;
  return s.step && at_least_m > s.step->edge_length_m * (1.0 + o.length_tolerance) + o.length_slack_m;
}

bool too_early(const Situation& s, const PhaseOptions& o) {
  const double at_most_m = s.travelled_m + o.odometry_drift_m_s * s.since_node_s;
  return s.step && at_most_m < s.step->edge_length_m * (1.0 - o.length_tolerance) - o.length_slack_m;
}

bool goal_holds(Phase phase, const Situation& s, const PhaseOptions& o) {
  switch (phase) {
    case Phase::take_off:
      return at_height(s, o);
    case Phase::align:
      return aligned(s, o);
    case Phase::dock:
      return docked(s, o);
    case Phase::turn:
    case Phase::look:
      return turned(s, o);
    case Phase::relaunch:
      return relaunched(s, o);
    case Phase::search:
      return found(s, o);
    default:
      return false;
  }
}

AbortReason abort_reason(Phase phase, const Situation& s, const PhaseOptions& o) {
  if (has_ended(phase)) return AbortReason::none;
  if (const AbortReason reason = abort_reason_of_vehicle(phase, s, o); reason != AbortReason::none)
    return reason;
  if (phase == Phase::take_off && s.phase_s > o.take_off_limit_s) return AbortReason::take_off_failed;
  if (phase == Phase::align && s.phase_s > o.align_limit_s) return AbortReason::line_lost;
  if (needs_line(phase) && is_out_of_sight(phase, s, o) && !s.may_search) return AbortReason::line_lost;
  if (phase == Phase::follow && s.line_off_s > o.turn_off_limit_s) return AbortReason::line_turns_off;
  if (phase == Phase::follow && s.stuck_s > o.stuck_limit_s) return AbortReason::stuck;
  if (phase == Phase::follow && s.node && s.node_puzzles) return AbortReason::node_unexpected;
  if (phase == Phase::follow && lost(s, o)) return AbortReason::node_overdue;
  if (phase == Phase::dock && is_out_of_sight(phase, s, o) && !s.may_search) return AbortReason::node_lost;
  if (phase == Phase::dock && s.phase_s > o.dock_limit_s) return AbortReason::node_lost;
  if (phase == Phase::search && s.search_is_over)
    return s.searched_from == Phase::dock ? AbortReason::node_lost : AbortReason::line_lost;
  const bool turns = phase == Phase::turn || phase == Phase::corner || phase == Phase::look;
  if (turns && s.phase_s > turn_limit_s(phase, o)) return AbortReason::turn_failed;
  if (phase == Phase::relaunch && s.phase_s > o.take_off_limit_s + o.dock_limit_s)
    return s.height_m < o.height_m - o.height_tolerance_m ? AbortReason::take_off_failed
                                                          : AbortReason::node_lost;
  return AbortReason::none;
}

Phase next(Phase phase, const Situation& s, const PhaseOptions& o) {
  if (abort_reason(phase, s, o) != AbortReason::none) return Phase::aborted;
  if (is_out_of_sight(phase, s, o)) return Phase::search;
  switch (phase) {
    case Phase::take_off:
      return settled(s, o) ? Phase::align : phase;
    case Phase::align:
      return settled(s, o) ? Phase::follow : phase;
    case Phase::follow:
      return after_node(s);
    case Phase::corner:
      if (!s.node_distance_m) return Phase::turn;  // out of sight: the turn is ended at rest
      return cornered(s, o) ? Phase::follow : phase;
    case Phase::dock:
      return settled(s, o) ? after_docking(s) : phase;
    case Phase::turn:
      return settled(s, o) ? Phase::follow : phase;
    case Phase::hover:
      return s.phase_s < hover_time_s(s, o) ? phase : after_hovering(s, o);
    case Phase::look:
      return settled(s, o) ? after_looking(s, o) : phase;
    case Phase::land:
      if (!s.on_ground) return phase;
      return s.is_last || s.gave_up ? Phase::finished : Phase::rest;
    case Phase::rest:
      return s.step && s.phase_s < s.step->stop.ground_s ? phase : Phase::relaunch;
    case Phase::relaunch:
      return settled(s, o) ? Phase::turn : phase;
    case Phase::aborted:
      return s.phase_s < hover_before_landing_s(s, o) ? phase : Phase::land;
    case Phase::finished:
      return phase;
    case Phase::search:
      return settled(s, o) ? s.searched_from : phase;
  }
  return Phase::aborted;
}

}  // namespace lineservo::servo
