#include "servo/executive/executive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "features/geometry/angles.h"
#include "servo/executive/sighting.h"
#include "servo/law/height_rate.h"

namespace lineservo::servo {
namespace {

VelocityCommand moving_as(const Observation& o) {
  if (!o.v_H_m_s.allFinite()) return {};
  return {o.v_H_m_s.x(), o.v_H_m_s.y(), o.v_H_m_s.z(), 0.0};
}

/// Phases that go by a place: the start marker or a node.
bool tracks_node(Phase phase) {
  return phase == Phase::align || phase == Phase::corner || phase == Phase::dock || phase == Phase::turn ||
         phase == Phase::hover || phase == Phase::land || phase == Phase::look || phase == Phase::relaunch;
}

std::string told(const NodeSighting& node) {
  if (node.bend != Bend::none) return std::string(name(node.bend));
  return std::string(features::name(node.code)) + (node.line_ends ? " (line ends)" : "");
}

bool turns(Phase phase) {
  return phase == Phase::turn || phase == Phase::corner || phase == Phase::look;
}

/// A corner that is ended at rest is the same turn still.
bool begins_turn(Phase from, Phase to) {
  return turns(to) && !(from == Phase::corner && to == Phase::turn);
}

}  // namespace

Executive::Executive(Plan plan, std::unique_ptr<FollowLaw> law, const LawTraits& traits,
                     const ExecutiveOptions& options)
    : plan_(std::move(plan)),
      law_(std::move(law)),
      traits_(traits),
      options_(options),
      dock_law_(options.dock),
      matcher_(options.confirm_frames),
      tracker_(options.tracker) {}

Command Executive::tick(const Observation& observation, bool on_ground) {
  observe(observation);
  const Situation situation = assess(observation, on_ground);
  const Phase decided = next(phase_, situation, options_.phases);
  if (decided == Phase::aborted && phase_ != Phase::aborted) {
    abort_reason_ = servo::abort_reason(phase_, situation, options_.phases);
  }
  if (node_ && phase_ == Phase::follow && decided != Phase::aborted) pass_node(observation.now);
  if (decided != phase_) enter(decided, observation);
  const double dt_s = last_tick_ ? seconds(observation.now - *last_tick_) : 0.0;
  last_tick_ = observation.now;
  return shape(command(observation), observation, dt_s);
}

void Executive::observe(const Observation& observation) {
  if (const features::LineFeature* line = line_to_follow(observation)) {
    const features::LineFeature now = after(since_capture(observation), *line, observation.capture_height_m);
    line_seen_ = observation.now;
    line_angle_rad_ = now.theta_rad;
    line_offset_m_ = now.rho * observation.height_m;
  } else {
    line_angle_rad_.reset();
    line_offset_m_.reset();
  }
  if (last_odometry_) travelled_m_ += between(*last_odometry_, observation.odometry_now).translation_m.x();
  last_odometry_ = observation.odometry_now;

  node_ = phase_ == Phase::follow ? node_told(observation) : std::nullopt;
  if (tracks_node(phase_) || node_ || (phase_ == Phase::follow && !matcher_.leaving())) {
    auto sighting =
        phase_ == Phase::align ? disc_sighting(observation) : node_sighting(observation, current_step());
    if (!sighting && turns(phase_))
      sighting = dead_end_sighting(observation, current_step(), tracker_.node_at_capture(observation));
    const bool is_left_behind = !tracks_node(phase_) && !node_ && sighting && sighting->x() < 0.0;
    if (is_left_behind) sighting.reset();  // still in view, but not the next one
    tracker_.observe(observation, sighting);
    if (sighting && tracks_node(phase_)) dock_law_.observe(observation, *sighting);
  }
  if (phase_ == Phase::align && tracker_.node_now(observation)) line_seen_ = observation.now;
  if (turns(phase_)) line_angle_rad_ = turn_.correct(observation);
  if (phase_ == Phase::look) lookout_.observe(observation);
  smooth_velocity(observation);
}

std::optional<NodeSighting> Executive::node_told(const Observation& observation) {
  const bool away = travelled_m_ > options_.leaving_heights * observation.height_m;
  const PlanStep* step = current_step();
  const bool by_arms = traits_.servos_on_node || (step && step->expected.bend == Bend::fork);
  const Bend bend = by_arms ? bend_sighting(observation, current_step())
                            : centroid_bend_.update(observation, current_step(), matcher_.leaving());
  return matcher_.update(near_reading(observation, current_step()), away, bend);
}

// A first-order low pass, v ← p·v + (1 − p)·(v̂ + d̂) with p = exp(−dt/τ): the noise of the estimate is as
// large as the speed below which the vehicle counts as at rest (vehicle/README.md).
void Executive::smooth_velocity(const Observation& observation) {
  const Eigen::Vector2d v_H_m_s = observation.v_H_m_s.head<2>() + node_drift_H_m_s(observation);
  if (!v_H_m_s.allFinite()) return;
  const double kept =
      last_tick_ ? std::exp(-seconds(observation.now - *last_tick_) / options_.speed_time_constant_s) : 0.0;
  velocity_H_m_s_ = kept * velocity_H_m_s_ + (1.0 - kept) * v_H_m_s;
}

Situation Executive::assess(const Observation& observation, bool on_ground) {
  Situation s;
  s.phase_s = seconds(observation.now - phase_began_);
  s.height_m = observation.height_m;
  s.line_unseen_s = seconds(observation.now - line_seen_);
  s.line_angle_rad = line_angle_rad_;
  s.line_offset_m = line_offset_m_;
  s.travelled_m = travelled_m_;
  s.since_node_s = seconds(observation.now - node_passed_);
  s.step = current_step();
  s.node = node_;
  if (const auto node = tracker_.node_now(observation)) s.node_distance_m = node->norm();
  s.speed_m_s = velocity_H_m_s_.norm();
  s.turn_left_rad = turn_left(observation);
  s.rounds_corner = phase_ == Phase::follow && arc_from_here(observation).speed_m_s > 0.0;
  if (const auto path = corner_path(observation)) {
    s.past_corner = path->nearest_way_m(Eigen::Vector2d::Zero()) > path->arc_end_m();
  }
  s.servos_on_node = traits_.servos_on_node;
  s.on_ground = on_ground;
  s.is_last = is_last_step();
  s.gave_up = abort_reason_ != AbortReason::none;
  const bool holds = goal_holds(phase_, s, options_.phases);
  if (holds && !goal_held_) goal_began_ = observation.now;
  goal_held_ = holds;
  s.settled_s = holds ? seconds(observation.now - goal_began_) : 0.0;
  return s;
}

void Executive::pass_node(Time now) {
  const PlanStep& step = plan_.steps[step_];
  ++nodes_recognised_;
  report("node", told(*node_) + ": " + std::string(name(step.manoeuvre)) + " at " + step.node);
  if (step.manoeuvre == Manoeuvre::go_straight) {
    ++step_;
    travelled_m_ = 0.0;
    node_passed_ = now;
    tracker_.reset();  // it must not slow the vehicle for the node behind
  }
}

void Executive::enter(Phase phase, const Observation& observation) {
  if (phase_ == Phase::look) report("look", lookout_.told() + " at " + current_step()->node);
  if (begins_turn(phase_, phase)) turn_ = turn_in(phase, observation);
  if (phase == Phase::look) lookout_ = Lookout(turn_.heading_in_rad());
  if (phase == Phase::dock || phase == Phase::corner || phase == Phase::relaunch) dock_law_.reset();
  if (phase == Phase::relaunch) tracker_.reset();
  if (phase == Phase::corner) arc_ = arc_from_here(observation);
  if (phase == Phase::follow) {
    const auto corner = phase_ == Phase::corner ? corner_path(observation) : std::nullopt;
    travelled_m_ = corner ? corner->nearest_way_m(Eigen::Vector2d::Zero()) : 0.0;
    if (turns(phase_)) ++step_;
    node_passed_ = observation.now;
    law_->reset();
    matcher_.restart();
    tracker_.reset();
  }
  if (phase == Phase::align) {
    law_->reset();
    dock_law_.reset();
  }
  report("phase", std::string(name(phase)) +
                      (phase == Phase::aborted ? ": " + std::string(name(abort_reason_)) : std::string()));
  phase_ = phase;
  phase_began_ = observation.now;
  goal_held_ = false;
  line_seen_ = observation.now;
}

Turn Executive::turn_in(Phase phase, const Observation& observation) const {
  const double heading_in_rad = observation.odometry_now.yaw_rad - line_angle_rad_.value_or(0.0);
  return Turn(heading_in_rad, phase == Phase::look ? 2.0 * features::kPi : current_step()->turn_rad);
}

Command Executive::command(const Observation& observation) {
  switch (phase_) {
    case Phase::take_off:
      return climb(observation);
    case Phase::align:
      return align(observation);
    case Phase::follow:
      return follow(observation);
    case Phase::corner:
      return corner(observation);
    case Phase::dock:
      return hold_node(observation);
    case Phase::turn:
    case Phase::look:
      return turn(observation);
    case Phase::hover:
      return hover(observation);
    case Phase::aborted:
      return stay(observation);
    case Phase::land:
      return land(observation);
    case Phase::rest:
      return LandCommand{};
    case Phase::relaunch:
      return relaunch(observation);
    case Phase::finished:
      return has_landed() ? Command(LandCommand{}) : Command(stay(observation));
  }
  return stay(observation);
}

// A velocity command that comes after one of another kind starts from how the vehicle moves.
Command Executive::shape(const Command& command, const Observation& observation, double dt_s) {
  const auto* wanted = std::get_if<VelocityCommand>(&command);
  if (!wanted || !is_finite(command)) {
    last_command_ = moving_as(observation);
    return is_finite(command) ? command : Command(VelocityCommand{});
  }
  last_command_ = approach(last_command_, saturate(*wanted, options_.limits), options_.limits, dt_s);
  return last_command_;
}

VelocityCommand Executive::climb(const Observation& observation) const {
  return {0.0, 0.0, height_rate(observation.height_m, options_.phases.height_m, 1.5, options_.climb_rate_m_s),
          0.0};
}

VelocityCommand Executive::stay(const Observation& observation, double yaw_rate_rad_s) const {
  return {0.0, 0.0, height_rate(observation.height_m, options_.phases.height_m), yaw_rate_rad_s};
}

// Above the start marker when there is one to be seen; a law that does not dock does so only while it sees no
// line.
Command Executive::align(const Observation& observation) {
  const bool holds_marker = tracker_.node_now(observation) && (traits_.servos_on_node || !line_angle_rad_);
  if (holds_marker) return hold_node(observation);
  if (traits_.servos_on_node) return follow_at(observation, 0.0, false);
  return stay(observation, turn_rate(-line_angle_rad_.value_or(0.0), options_.turn));
}

Command Executive::follow(const Observation& observation) {
  const PlanStep* step = current_step();
  return follow_at(observation, approach_speed(observation), step && step->edge_bends);
}

Command Executive::follow_at(const Observation& observation, double speed_m_s, bool curved) {
  const bool yaws_itself = traits_.steers_heading || (curved && traits_.yaws_on_bends);
  const double held_rad_s = yaws_itself ? 0.0 : heading_hold_rad_s();
  Command command = law_->follow(observation, {speed_m_s, options_.phases.height_m, curved, held_rad_s});
  auto* velocity = std::get_if<VelocityCommand>(&command);
  if (velocity && line_angle_rad_ && !yaws_itself) velocity->yaw_rate_rad_s = held_rad_s;
  return command;
}

// The published lateral laws take the heading for given: their autopilots have a compass. Indoors there is
// none, so the line's angle stands in for it, slowly.
double Executive::heading_hold_rad_s() const {
  return std::clamp(-options_.heading_gain_per_s * line_angle_rad_.value_or(0.0),
                    -options_.heading_rate_limit_rad_s, options_.heading_rate_limit_rad_s);
}

// Before a node to dock on, and where the line stops: so that the point task takes over with little left to
// brake. Before a corner to be rounded: down to the arc's speed where the arc begins.
double Executive::approach_speed(const Observation& observation) const {
  const std::optional<double> ahead_m = stop_ahead_m(observation);
  if (!traits_.servos_on_node || !ahead_m) return options_.speed_m_s;
  const CornerArc arc = planned_arc();
  const double to_arc_m = *ahead_m - arc.radius_m;  // no turn that is rounded needs more than its radius
  return std::min(options_.speed_m_s, braking_speed(to_arc_m, arc.speed_m_s, options_.approach));
}

// How far ahead the vehicle has to stop, as far as it is in view.
std::optional<double> Executive::stop_ahead_m(const Observation& observation) const {
  const PlanStep* step = current_step();
  if (!step || step->manoeuvre == Manoeuvre::go_straight) return std::nullopt;
  if (const auto node = tracker_.node_now(observation)) return node->x();
  if (!observation.features.line_end || matcher_.leaving()) return std::nullopt;
  const Eigen::Vector2d end_m = floor_point_m(*observation.features.line_end, observation.capture_height_m);
  return after(since_capture(observation), end_m).x();
}

VelocityCommand Executive::hold_node(const Observation& observation) {
  const auto node = tracker_.node_now(observation);
  if (!node) return stay(observation);
  VelocityCommand c = dock_law_.hold(observation, {*node, line_angle_rad_, 0.0, options_.phases.height_m});
  CommandLimits limits = options_.limits;
  limits.horizontal_m_s = std::max(options_.speed_m_s, options_.approach.speed_m_s);
  return saturate(c, limits);
}

Command Executive::hover(const Observation& observation) {
  if (traits_.servos_on_node) return hold_node(observation);
  const auto command = law_->hover(observation, {0.0, options_.phases.height_m, false});
  return command.value_or(stay(observation));
}

/// Of the turn that comes; none when it is made at rest.
CornerArc Executive::planned_arc() const {
  const PlanStep* step = current_step();
  const bool is_turn = step && step->manoeuvre == Manoeuvre::turn;
  if (!is_turn || std::abs(step->turn_rad) > options_.corner.turn_max_rad) return {};
  return corner_arc(step->turn_rad, options_.speed_m_s, options_.corner);
}

/// None when the node is so near that the vehicle would have to slow down much for what is left.
CornerArc Executive::arc_from_here(const Observation& observation) const {
  constexpr double kLeastShare = 0.6;  // of the planned speed
  const auto node = tracker_.node_now(observation);
  const CornerArc planned = planned_arc();
  if (!node || planned.radius_m <= 0.0) return {};
  const CornerArc arc = shortened(planned, current_step()->turn_rad, node->x(), options_.corner);
  return arc.speed_m_s >= kLeastShare * planned.speed_m_s ? arc : CornerArc{};
}

/// The corner that is being flown, in the heading frame now.
std::optional<CornerPath> Executive::corner_path(const Observation& observation) const {
  const auto node = tracker_.node_now(observation);
  if (phase_ != Phase::corner || !node) return std::nullopt;
  const double yaw_rad = observation.odometry_now.yaw_rad;
  return CornerPath(*node, turn_.heading_in_rad() - yaw_rad, turn_.heading_out_rad() - turn_.heading_in_rad(),
                    arc_.radius_m);
}

// The nearest place on the path is held by the point task, while the path's velocity, at the place where the
// vehicle will have answered, is fed forward. The heading turns about the middle of the arc.
VelocityCommand Executive::corner(const Observation& observation) {
  const auto path = corner_path(observation);
  if (!path) return stay(observation, turn_rate(turn_left(observation), options_.turn));
  const double way_m = path->nearest_way_m(Eigen::Vector2d::Zero());
  const double to_arc_m = -path->arc_end_m() - way_m;
  const double speed_m_s =
      std::min(options_.speed_m_s, braking_speed(to_arc_m, arc_.speed_m_s, options_.approach));
  const double heading_rad = path->heading_rad(way_m + speed_m_s * options_.approach.response_s);
  const bool turns_now =
      way_m > -0.5 * speed_m_s * turn_time_s(turn_.heading_out_rad() - turn_.heading_in_rad(), options_.turn);
  const double left_rad =
      turns_now ? turn_left(observation) : turn_.heading_in_rad() - observation.odometry_now.yaw_rad;
  DockGoal goal{path->point_m(way_m), std::nullopt, turn_rate(left_rad, options_.turn),
                options_.phases.height_m};
  goal.velocity_H_m_s = speed_m_s * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
  return dock_law_.hold(observation, goal);
}

// Above the node as long as the height lets the camera see it; the autopilot does the rest.
Command Executive::land(const Observation& observation) {
  const auto node = tracker_.node_now(observation);
  const double blind_m = options_.blind_share * options_.phases.height_m;
  if (!traits_.servos_on_node || !node || !(observation.height_m > blind_m)) return LandCommand{};
  return dock_law_.hold(observation,
                        {*node, line_angle_rad_, 0.0, options_.descent_share * observation.height_m});
}

// Straight up while the camera is too low to see the node.
VelocityCommand Executive::relaunch(const Observation& observation) {
  const bool sees = traits_.servos_on_node && tracker_.node_now(observation);
  return sees ? hold_node(observation) : climb(observation);
}

VelocityCommand Executive::turn(const Observation& observation) {
  const double rate = turn_rate(turn_left(observation), options_.turn);
  const auto node = tracker_.node_now(observation);
  if (!traits_.servos_on_node || !node) return stay(observation, rate);
  return dock_law_.hold(observation, {*node, std::nullopt, rate, options_.phases.height_m});
}

// What the velocity estimate does not know of: over a node vision tells it.
Eigen::Vector2d Executive::node_drift_H_m_s(const Observation& observation) const {
  return tracks_node(phase_) ? dock_law_.drift_H_m_s(observation) : Eigen::Vector2d::Zero();
}

double Executive::turn_left(const Observation& observation) const {
  return turns(phase_) ? turn_.left_rad(observation) : 0.0;
}

// A flight that was broken off ends on the ground as well, and has to stay there.
bool Executive::has_landed() const {
  return options_.phases.land || plan_.steps.back().stop.land || abort_reason_ != AbortReason::none;
}

const PlanStep* Executive::current_step() const {
  return step_ < plan_.steps.size() ? &plan_.steps[step_] : nullptr;
}

void Executive::report(std::string kind, std::string detail) {
  events_.push_back({std::move(kind), std::move(detail)});
}

std::vector<ExecutiveEvent> Executive::take_events() {
  return std::exchange(events_, {});
}

}  // namespace lineservo::servo
