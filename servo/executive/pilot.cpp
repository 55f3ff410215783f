#include "servo/executive/pilot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "features/geometry/angles.h"
#include "servo/law/height_rate.h"

namespace lineservo::servo {
namespace {

VelocityCommand moving_as(const Observation& o) {
  if (!o.estimate.v_H_m_s.allFinite()) return {};
  return {o.estimate.v_H_m_s.x(), o.estimate.v_H_m_s.y(), o.estimate.v_H_m_s.z(), 0.0};
}

constexpr double kLiesAcross_rad = features::radians(45.0);

/// A corner that is ended at rest is the same turn still.
bool begins_turn(Phase from, Phase to) {
  return turns(to) && !(from == Phase::corner && to == Phase::turn);
}

}  // namespace

Pilot::Pilot(std::unique_ptr<FollowLaw> law, const LawTraits& traits, const ExecutiveOptions& options)
    : law_(std::move(law)),
      traits_(traits),
      options_(options),
      dock_law_(options.dock),
      tracker_(options.tracker) {}

bool Pilot::see_line(const Observation& observation) {
  line_angle_rad_.reset();
  line_offset_m_.reset();
  const features::LineFeature* line = line_to_follow(observation);
  if (!line) return false;
  const features::LineFeature now =
      after(since_capture(observation), *line, observation.estimate.capture_height_m);
  line_angle_rad_ = now.theta_rad;
  line_offset_m_ = now.rho * observation.estimate.height_m;
  last_line_ = LastLine{observation.estimate.odometry_now, *line_offset_m_, *line_angle_rad_};
  return true;
}

void Pilot::see_first_edge(const Observation& observation) {
  const bool lies_across = line_angle_rad_ && std::abs(*line_angle_rad_) > kLiesAcross_rad;
  if (lies_across) {
    line_angle_rad_.reset();
    line_offset_m_.reset();
  }
  looks_ahead_ = seconds(observation.now - align_began_) > options_.look_ahead_after_s;
}

void Pilot::see_node(const Observation& observation, const std::optional<Eigen::Vector2d>& sighting_m,
                     bool goes_by_it) {
  const bool counts = tracker_.observe(observation, sighting_m);
  if (counts && goes_by_it) dock_law_.observe(observation, *sighting_m);
}

void Pilot::change(Phase from, const Orders& orders, const Observation& observation) {
  const Phase to = orders.phase;
  if (begins_turn(from, to)) turn_ = turn_in(orders, observation);
  if (to == Phase::corner) arc_ = arc_from_here(orders.step, observation);
  if (to == Phase::dock || to == Phase::corner || to == Phase::align || to == Phase::relaunch)
    dock_law_.reset();
  if (to == Phase::relaunch) tracker_.reset();
  if (to == Phase::follow || to == Phase::align) law_->reset();
  if (to == Phase::align) {
    align_began_ = observation.now;
    looks_ahead_ = false;
  }
}

Turn Pilot::turn_in(const Orders& orders, const Observation& observation) const {
  const double heading_in_rad = observation.estimate.odometry_now.yaw_rad - line_angle_rad_.value_or(0.0);
  return Turn(heading_in_rad, orders.phase == Phase::look ? 2.0 * features::kPi : orders.step->turn_rad);
}

Command Pilot::fly(const Orders& orders, const Observation& observation, double dt_s) {
  return shape(command(orders, observation), observation, dt_s);
}

bool Pilot::rounds_corner(const PlanStep* step, const Observation& observation) const {
  return arc_from_here(step, observation).speed_m_s > 0.0;
}

std::optional<double> Pilot::corner_way_m(const Observation& observation) const {
  const auto path = corner_path(observation);
  if (!path) return std::nullopt;
  return path->nearest_way_m(Eigen::Vector2d::Zero());
}

bool Pilot::past_corner(const Observation& observation) const {
  const auto path = corner_path(observation);
  return path && path->nearest_way_m(Eigen::Vector2d::Zero()) > path->arc_end_m();
}

Eigen::Vector2d Pilot::flies_towards_H() const {
  const Eigen::Vector2d wanted_m_s(last_command_.forward_m_s, last_command_.left_m_s);
  return wanted_m_s.normalized();
}

Command Pilot::command(const Orders& orders, const Observation& observation) {
  switch (orders.phase) {
    case Phase::take_off:
      return climb(observation);
    case Phase::align:
      return align(observation);
    case Phase::follow:
      return follow(orders, observation);
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
    case Phase::search:
      return search(observation);
    case Phase::rest:
      return LandCommand{};
    case Phase::relaunch:
      return relaunch(observation);
    case Phase::finished:
      return orders.keeps_landed ? Command(LandCommand{}) : Command(stay(observation));
  }
  return stay(observation);
}

// A velocity command that comes after one of another kind starts from how the vehicle moves.
Command Pilot::shape(const Command& command, const Observation& observation, double dt_s) {
  if (is_finite(command)) refuses_since_.reset();
  if (!is_finite(command) && !refuses_since_) refuses_since_ = observation.now;
  const auto* wanted = std::get_if<VelocityCommand>(&command);
  if (!wanted || !is_finite(command)) {
    last_command_ = moving_as(observation);
    return is_finite(command) ? command : Command(VelocityCommand{});
  }
  last_command_ = approach(last_command_, saturate(*wanted, options_.limits), options_.limits, dt_s);
  return last_command_;
}

VelocityCommand Pilot::climb(const Observation& observation) const {
  return {0.0, 0.0,
          height_rate(observation.estimate.height_m, options_.phases.height_m, 1.5, options_.climb_rate_m_s),
          0.0};
}

VelocityCommand Pilot::stay(const Observation& observation, double yaw_rate_rad_s) const {
  return {0.0, 0.0, height_rate(observation.estimate.height_m, options_.phases.height_m), yaw_rate_rad_s};
}

// Above the start marker when there is one to be seen; a law that does not dock does so only while it sees no
// line.
Command Pilot::align(const Observation& observation) {
  const bool holds_marker = tracker_.node_now(observation) && (traits_.servos_on_node || !line_angle_rad_);
  if (holds_marker) {
    const double ahead_m = looks_ahead_ ? options_.look_ahead_heights * options_.phases.height_m : 0.0;
    return hold_node(observation, {ahead_m, 0.0});
  }
  if (traits_.servos_on_node) return follow_at(observation, 0.0, nullptr);
  return stay(observation, turn_rate(-line_angle_rad_.value_or(0.0), options_.turn));
}

Command Pilot::follow(const Orders& orders, const Observation& observation) {
  return follow_at(observation, approach_speed(orders, observation), orders.step);
}

Command Pilot::follow_at(const Observation& observation, double speed_m_s, const PlanStep* step) {
  const bool curved = step && step->edge_bends;
  const bool pursues = step && step->pursued;
  const bool yaws_itself = traits_.steers_heading || pursues || (curved && traits_.yaws_on_bends);
  const double held_rad_s = yaws_itself ? 0.0 : heading_hold_rad_s();
  Command command = law_->follow(observation, {speed_m_s, options_.phases.height_m, curved, held_rad_s});
  auto* velocity = std::get_if<VelocityCommand>(&command);
  if (velocity && line_angle_rad_ && !yaws_itself) velocity->yaw_rate_rad_s = held_rad_s;
  return command;
}

// The published lateral laws take the heading for given: their autopilots have a compass. Indoors there is
// none, so the line's angle stands in for it, slowly.
double Pilot::heading_hold_rad_s() const {
  return std::clamp(-options_.heading_gain_per_s * line_angle_rad_.value_or(0.0),
                    -options_.heading_rate_limit_rad_s, options_.heading_rate_limit_rad_s);
}

// Before a node to dock on, and where the line stops: so that the point task takes over with little left to
// brake. Before a corner to be rounded: down to the arc's speed where the arc begins.
double Pilot::approach_speed(const Orders& orders, const Observation& observation) const {
  const std::optional<double> ahead_m = stop_ahead_m(orders, observation);
  if (!traits_.servos_on_node || !ahead_m) return options_.speed_m_s;
  const CornerArc arc = planned_arc(orders.step);
  const double to_arc_m = *ahead_m - arc.radius_m;  // no turn that is rounded needs more than its radius
  return std::min(options_.speed_m_s, braking_speed(to_arc_m, arc.speed_m_s, options_.approach));
}

// How far ahead the vehicle has to stop, as far as it is in view.
std::optional<double> Pilot::stop_ahead_m(const Orders& orders, const Observation& observation) const {
  const PlanStep* step = orders.step;
  if (!step || step->manoeuvre == Manoeuvre::go_straight) return std::nullopt;
  if (const auto node = tracker_.node_now(observation)) return node->x();
  if (!observation.features.line_end || orders.leaving) return std::nullopt;
  const Eigen::Vector2d end_m =
      floor_point_m(*observation.features.line_end, observation.estimate.capture_height_m);
  return after(since_capture(observation), end_m).x();
}

VelocityCommand Pilot::hold_node(const Observation& observation, const Eigen::Vector2d& from_it_H_m) {
  const auto node = tracker_.node_now(observation);
  if (!node) return stay(observation);
  const Eigen::Vector2d place_m = *node + from_it_H_m;
  VelocityCommand c = dock_law_.hold(observation, {place_m, line_angle_rad_, 0.0, options_.phases.height_m});
  CommandLimits limits = options_.limits;
  limits.horizontal_m_s = std::max(options_.speed_m_s, options_.approach.speed_m_s);
  return saturate(c, limits);
}

Command Pilot::hover(const Observation& observation) {
  if (traits_.servos_on_node) return hold_node(observation);
  const auto command = law_->hover(observation, {0.0, options_.phases.height_m, false});
  return command.value_or(stay(observation));
}

/// Of the turn that comes; none when it is made at rest.
CornerArc Pilot::planned_arc(const PlanStep* step) const {
  const bool is_turn = step && step->manoeuvre == Manoeuvre::turn;
  if (!is_turn || std::abs(step->turn_rad) > options_.corner.turn_max_rad) return {};
  return corner_arc(step->turn_rad, options_.speed_m_s, options_.corner);
}

/// None when the node is so near that the vehicle would have to slow down much for what is left.
CornerArc Pilot::arc_from_here(const PlanStep* step, const Observation& observation) const {
  constexpr double kLeastShare = 0.6;  // of the planned speed
  const auto node = tracker_.node_now(observation);
  const CornerArc planned = planned_arc(step);
  if (!node || planned.radius_m <= 0.0) return {};
  const CornerArc arc = shortened(planned, step->turn_rad, node->x(), options_.corner);
  return arc.speed_m_s >= kLeastShare * planned.speed_m_s ? arc : CornerArc{};
}

/// The corner that is being flown, in the heading frame now.
std::optional<CornerPath> Pilot::corner_path(const Observation& observation) const {
  const auto node = tracker_.node_now(observation);
  if (!node) return std::nullopt;
  const double yaw_rad = observation.estimate.odometry_now.yaw_rad;
  return CornerPath(*node, turn_.heading_in_rad() - yaw_rad, turn_.heading_out_rad() - turn_.heading_in_rad(),
                    arc_.radius_m);
}

// The nearest place on the path is held by the point task, while the path's velocity, at the place where the
// vehicle will have answered, is fed forward. The heading turns about the middle of the arc.
VelocityCommand Pilot::corner(const Observation& observation) {
  const auto path = corner_path(observation);
  if (!path) return stay(observation, turn_rate(turn_left_rad(observation), options_.turn));
  const double way_m = path->nearest_way_m(Eigen::Vector2d::Zero());
  const double to_arc_m = -path->arc_end_m() - way_m;
  const double speed_m_s =
      std::min(options_.speed_m_s, braking_speed(to_arc_m, arc_.speed_m_s, options_.approach));
  const double heading_rad = path->heading_rad(way_m + speed_m_s * options_.approach.response_s);
  const bool turns_now =
      way_m > -0.5 * speed_m_s * turn_time_s(turn_.heading_out_rad() - turn_.heading_in_rad(), options_.turn);
  const double left_rad = turns_now ? turn_left_rad(observation)
                                    : turn_.heading_in_rad() - observation.estimate.odometry_now.yaw_rad;
  DockGoal goal{path->point_m(way_m), std::nullopt, turn_rate(left_rad, options_.turn),
                options_.phases.height_m};
  goal.velocity_H_m_s = speed_m_s * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
  return dock_law_.hold(observation, goal);
}

// Above the node as long as the height lets the camera see it, then straight down; the autopilot does the
// rest.
Command Pilot::land(const Observation& observation) {
  if (!traits_.servos_on_node || !(observation.estimate.height_m > options_.touch_down_m))
    return LandCommand{};
  if (observation.estimate.height_m < options_.blind_share * options_.phases.height_m)
    return sink(observation);
  const auto node = tracker_.node_now(observation);
  if (!node) return LandCommand{};
  return dock_law_.hold(
      observation, {*node, line_angle_rad_, 0.0, options_.descent_share * observation.estimate.height_m});
}

VelocityCommand Pilot::search(const Observation& observation) {
  VelocityCommand command = stay(observation);
  const Eigen::Vector2d v_H_m_s = search_.velocity_H_m_s(observation);
  command.forward_m_s = v_H_m_s.x();
  command.left_m_s = v_H_m_s.y();
  return command;
}

// Straight up while the camera is too low to see the node.
VelocityCommand Pilot::relaunch(const Observation& observation) {
  const bool sees = traits_.servos_on_node && tracker_.node_now(observation);
  return sees ? hold_node(observation) : climb(observation);
}

// Straight down, less the drift that was learnt above the node.
VelocityCommand Pilot::sink(const Observation& observation) const {
  const Eigen::Vector2d drift_H_m_s = dock_law_.drift_H_m_s(observation);
  return {-drift_H_m_s.x(), -drift_H_m_s.y(), -options_.sink_rate_m_s, 0.0};
}

VelocityCommand Pilot::turn(const Observation& observation) {
  const double rate = turn_rate(turn_left_rad(observation), options_.turn);
  const auto node = tracker_.node_now(observation);
  if (!traits_.servos_on_node || !node) return stay(observation, rate);
  return dock_law_.hold(observation, {*node, std::nullopt, rate, options_.phases.height_m});
}

}  // namespace lineservo::servo
