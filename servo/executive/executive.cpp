#include "servo/executive/executive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "servo/executive/sighting.h"

namespace lineservo::servo {
namespace {

constexpr int kSearches = 2;  // about one place
constexpr double kSamePlace_m = 1.0;

/// Phases that go by a place: the start marker or a node.
bool tracks_node(Phase phase) {
  return phase == Phase::align || phase == Phase::search || phase == Phase::corner || phase == Phase::dock ||
         phase == Phase::turn || phase == Phase::hover || phase == Phase::land || phase == Phase::look ||
         phase == Phase::relaunch;
}

std::string told(const NodeSighting& node) {
  if (node.bend != Bend::none) return std::string(name(node.bend));
  return std::string(features::name(node.code)) + (node.line_ends ? " (line ends)" : "");
}

}  // namespace

Executive::Executive(Plan plan, std::unique_ptr<FollowLaw> law, const LawTraits& traits,
                     const ExecutiveOptions& options)
    : navigator_(std::move(plan)),
      traits_(traits),
      options_(options),
      pilot_(std::move(law), traits, options),
      matcher_(options.confirm_frames, options.doubt_frames) {}

Command Executive::tick(const Observation& observation, bool on_ground) {
  const Observation& sound = guard_.checked(observation);
  if (auto news = guard_.take_news()) report("guard", std::move(*news));
  return decide(keep_straight(sound), on_ground);
}

// Where two branches look alike, perception may name either first.
const Observation& Executive::keep_straight(const Observation& observation) {
  const PlanStep* step = current_step();
  const bool is_straight = step && !step->edge_bends;
  if (phase_ != Phase::follow || matcher_.leaving() || !is_straight || !traits_.servos_on_node) {
    compass_.restart();
    return observation;
  }
  const std::size_t k = compass_.straight_on(observation);
  if (k == 0) return observation;
  reordered_ = observation;
  auto& lines = reordered_.features.lines;
  std::rotate(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(k),
              lines.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  return reordered_;
}

Command Executive::decide(const Observation& observation, bool on_ground) {
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
  return pilot_.fly(orders(), observation, dt_s);
}

void Executive::observe(const Observation& observation) {
  const bool sees_line = pilot_.see_line(observation);
  if (sees_line || (pursues() && observation.features.law.target)) line_seen_ = observation.now;
  if (last_odometry_)
    travelled_m_ += along_way_m(between(*last_odometry_, observation.estimate.odometry_now).translation_m);
  last_odometry_ = observation.estimate.odometry_now;
  note_progress(observation.now);

  node_ = phase_ == Phase::follow ? node_told(observation) : std::nullopt;
  node_puzzles_ = false;
  if (node_) judge_node(observation);
  if (tracks_node(phase_) || node_ || (phase_ == Phase::follow && !matcher_.leaving())) {
    auto sighting =
        phase_ == Phase::align ? disc_sighting(observation) : node_sighting(observation, current_step());
    if (!sighting && turns(phase_))
      sighting = dead_end_sighting(observation, current_step(), pilot_.node_at_capture(observation));
    const bool is_left_behind = !tracks_node(phase_) && !node_ && sighting && sighting->x() < 0.0;
    if (is_left_behind) sighting.reset();  // still in view, but not the next one
    pilot_.see_node(observation, sighting, tracks_node(phase_));
  }
  if (phase_ == Phase::align) pilot_.see_first_edge(observation);
  if (phase_ == Phase::align && pilot_.node_now(observation)) line_seen_ = observation.now;
  if (turns(phase_)) pilot_.see_turn(observation);
  if (phase_ == Phase::look) lookout_.observe(observation);
  smooth_velocity(observation);
}

// Along the heading, which is the line's; a law that pursues the line leaves the heading where it is.
double Executive::along_way_m(const Eigen::Vector2d& moved_H_m) const {
  return pursues() ? moved_H_m.dot(pilot_.flies_towards_H()) : moved_H_m.x();
}

// Going back and forth before an obstacle to the law is no progress.
void Executive::note_progress(Time now) {
  constexpr double kWay_m = 0.1;
  const bool begins = phase_ != Phase::follow || travelled_m_ < advanced_m_ - 2.0 * kWay_m;
  if (!begins && travelled_m_ < advanced_m_ + kWay_m) return;
  advanced_m_ = travelled_m_;
  advanced_at_ = now;
}

std::optional<NodeSighting> Executive::node_told(const Observation& observation) {
  const bool away = travelled_m_ - told_at_m_ > options_.leaving_heights * observation.estimate.height_m;
  const PlanStep* step = current_step();
  const NodeSignature* expected = step ? &step->expected : nullptr;
  const bool by_arms = traits_.servos_on_node || (expected && expected->bend == Bend::fork);
  const Bend bend = by_arms ? bend_sighting(observation, step)
                            : centroid_bend_.update(observation, step, matcher_.leaving());
  return matcher_.update(near_reading(observation, step), away, bend, expected);
}

// A node that the plan does not expect is held against all that was passed before: it may be a ghost, or the
// vehicle may be elsewhere than planned.
void Executive::judge_node(const Observation& observation) {
  const double way_m = travelled_m_ - told_at_m_;
  const double drift_m =
      options_.phases.odometry_drift_m_s * seconds(observation.now - std::max(told_at_, node_passed_));
  Situation s;
  s.step = current_step();
  s.travelled_m = travelled_m_;
  s.since_node_s = seconds(observation.now - node_passed_);
  const auto verdict =
      navigator_.judge(*node_, {way_m - drift_m, way_m + drift_m}, !too_early(s, options_.phases));
  told_at_m_ = travelled_m_;
  told_at_ = observation.now;
  node_puzzles_ = verdict == Navigator::Verdict::puzzling;
  if (verdict == Navigator::Verdict::as_planned) return;
  report("unexpected", told(*node_) + ", " + navigator_.place());
  if (verdict == Navigator::Verdict::planned_anew) {
    report("plan", "anew from " + current_step()->node + " to " + navigator_.plan().target);
    travelled_m_ = told_at_m_ = 0.0;
  }
  if (verdict == Navigator::Verdict::ignored) node_.reset();
}

// A first-order low pass, v ← p·v + (1 − p)·(v̂ + d̂) with p = exp(−dt/τ): the noise of the estimate is as
// large as the speed below which the vehicle counts as at rest (vehicle/README.md).
void Executive::smooth_velocity(const Observation& observation) {
  const Eigen::Vector2d v_H_m_s = observation.estimate.v_H_m_s.head<2>() + node_drift_H_m_s(observation);
  if (!v_H_m_s.allFinite()) return;
  const double kept =
      last_tick_ ? std::exp(-seconds(observation.now - *last_tick_) / options_.speed_time_constant_s) : 0.0;
  velocity_H_m_s_ = kept * velocity_H_m_s_ + (1.0 - kept) * v_H_m_s;
}

Situation Executive::assess(const Observation& observation, bool on_ground) {
  Situation s;
  s.phase_s = seconds(observation.now - phase_began_);
  s.height_m = observation.estimate.height_m;
  s.line_unseen_s = seconds(observation.now - line_seen_);
  s.line_angle_rad = pilot_.line_angle_rad();
  s.line_offset_m = pilot_.line_offset_m();
  s.travelled_m = travelled_m_;
  s.since_node_s = seconds(observation.now - node_passed_);
  s.step = current_step();
  s.node = node_;
  if (const auto node = pilot_.node_now(observation)) s.node_distance_m = node->norm();
  s.speed_m_s = velocity_H_m_s_.norm();
  s.turn_left_rad = turns(phase_) ? pilot_.turn_left_rad(observation) : 0.0;
  s.rounds_corner = phase_ == Phase::follow && pilot_.rounds_corner(current_step(), observation);
  s.past_corner = phase_ == Phase::corner && pilot_.past_corner(observation);
  s.looks_ahead = phase_ == Phase::align && pilot_.looks_ahead();
  s.servos_on_node = traits_.servos_on_node;
  s.on_ground = on_ground;
  assess_health(observation, s);
  s.is_last = is_last_step();
  s.gave_up = abort_reason_ != AbortReason::none;
  const bool holds = goal_holds(phase_, s, options_.phases);
  if (holds && !goal_held_) goal_began_ = observation.now;
  goal_held_ = holds;
  s.settled_s = holds ? seconds(observation.now - goal_began_) : 0.0;
  return s;
}

void Executive::assess_health(const Observation& observation, Situation& s) const {
  const Eigen::Vector2d here_m = observation.estimate.odometry_now.translation_m;
  s.flight_s = seconds(observation.now);
  s.height_age_s = observation.estimate.height_age_s;
  s.velocity_age_s = observation.estimate.velocity_age_s;
  const auto& refuses_since = pilot_.refuses_since();
  s.not_finite_s =
      std::max(guard_.bad_for_s(), refuses_since ? seconds(observation.now - *refuses_since) : 0.0);
  s.node_puzzles = node_puzzles_;
  s.stuck_s = phase_ == Phase::follow ? seconds(observation.now - advanced_at_) : 0.0;
  s.line_off_s = compass_.off_for_s();
  s.lost_limit_m = navigator_.lost_limit_m();
  s.may_search = searches_ < kSearches || (here_m - searched_at_m_).norm() > kSamePlace_m;
  s.search_is_over = pilot_.search_is_over(observation.now);
  s.searched_from = searched_from_;
  s.given_up = abort_reason_;
}

void Executive::pass_node(Time now) {
  const PlanStep& step = *current_step();
  ++nodes_recognised_;
  report("node", told(*node_) + ": " + std::string(name(step.manoeuvre)) + " at " + step.node);
  if (step.manoeuvre == Manoeuvre::go_straight) {
    navigator_.advance();
    travelled_m_ = told_at_m_ = 0.0;
    node_passed_ = now;
    pilot_.forget_node();  // it must not slow the vehicle for the node behind
  }
}

void Executive::enter(Phase phase, const Observation& observation) {
  const Phase from = std::exchange(phase_, phase);
  if (from == Phase::look) report("look", lookout_.told() + " at " + current_step()->node);
  pilot_.change(from, orders(), observation);
  if (phase == Phase::look) lookout_ = Lookout(pilot_.heading_in_rad());
  if (phase == Phase::follow && from != Phase::search) begin_leg(from, observation);
  if (phase == Phase::search) begin_search(from, observation);
  report("phase", std::string(name(phase)) +
                      (phase == Phase::aborted ? ": " + std::string(name(abort_reason_)) : std::string()));
  phase_began_ = observation.now;
  goal_held_ = false;
  line_seen_ = observation.now;
}

void Executive::begin_search(Phase from, const Observation& observation) {
  const Eigen::Vector2d here_m = observation.estimate.odometry_now.translation_m;
  if ((here_m - searched_at_m_).norm() > kSamePlace_m) searches_ = 0;
  searched_at_m_ = here_m;
  searched_from_ = from;
  pilot_.begin_search(searches_++, observation.now);
}

// Round a corner part of the next edge is flown already.
void Executive::begin_leg(Phase from, const Observation& observation) {
  const auto corner_m = from == Phase::corner ? pilot_.corner_way_m(observation) : std::nullopt;
  travelled_m_ = corner_m.value_or(0.0);
  told_at_m_ = 0.0;
  if (turns(from)) navigator_.advance();
  node_passed_ = observation.now;
  matcher_.restart();
  pilot_.forget_node();
}

Orders Executive::orders() const {
  return {phase_, current_step(), matcher_.leaving(), has_landed()};
}

// What the velocity estimate does not know of: over a node vision tells it.
Eigen::Vector2d Executive::node_drift_H_m_s(const Observation& observation) const {
  return tracks_node(phase_) ? pilot_.drift_H_m_s(observation) : Eigen::Vector2d::Zero();
}

// A flight that was broken off ends on the ground as well, and has to stay there.
bool Executive::has_landed() const {
  return options_.phases.land || plan().steps.back().stop.land || abort_reason_ != AbortReason::none;
}

bool Executive::pursues() const {
  return phase_ == Phase::follow && current_step() && current_step()->pursued;
}

void Executive::report(std::string kind, std::string detail) {
  events_.push_back({std::move(kind), std::move(detail)});
}

std::vector<ExecutiveEvent> Executive::take_events() {
  return std::exchange(events_, {});
}

}  // namespace lineservo::servo
