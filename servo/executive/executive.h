#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "servo/executive/approach.h"
#include "servo/executive/corner.h"
#include "servo/executive/junction_matcher.h"
#include "servo/executive/lookout.h"
#include "servo/executive/node_tracker.h"
#include "servo/executive/phase.h"
#include "servo/executive/sighting.h"
#include "servo/executive/turn.h"
#include "servo/executive/turn_profile.h"
#include "servo/law/dock_law.h"
#include "servo/law/follow_law.h"
#include "servo/law/limits.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {

struct ExecutiveOptions {
  double speed_m_s = 0.1;
  PhaseOptions phases;
  ApproachOptions approach;
  CornerOptions corner;
  TurnOptions turn;
  DockOptions dock;
  NodeTracker::Options tracker;
  CommandLimits limits;
  int confirm_frames = 2;
  double leaving_heights =
      0.7;  ///< a node left behind is in view for so far a way, in heights: half the view
  double climb_rate_m_s = 0.4;
  double heading_gain_per_s = 0.5;  ///< for laws that do not steer the heading
  double heading_rate_limit_rad_s = 0.1;
  double blind_share = 0.4;    ///< of the height of flight, below which a node is no guide for landing
  double descent_share = 0.8;  ///< height aimed at on the way down, of that now
  double speed_time_constant_s = 0.5;  ///< over which the speed that counts as rest is averaged
};

/// Something worth a line in events.csv.
struct ExecutiveEvent {
  std::string kind;
  std::string detail;
};

/// Carries out a plan: recognises nodes by their codes, chooses the phase, and lets the phase's law speak.
class Executive {
 public:
  Executive(Plan plan, std::unique_ptr<FollowLaw> law, const LawTraits& traits,
            const ExecutiveOptions& options);

  /// One control tick: observe → assess → decide → command → shape.
  Command tick(const Observation& observation, bool on_ground);

  Phase phase() const { return phase_; }
  AbortReason abort_reason() const { return abort_reason_; }
  /// Index of the plan's step that is expected next or being carried out.
  std::size_t step() const { return step_; }
  /// How many nodes of the plan were recognised as expected.
  int nodes_recognised() const { return nodes_recognised_; }
  const Plan& plan() const { return plan_; }
  /// A landing now is the end of the flight: no target comes after it, or the flight was broken off.
  bool ends_on_ground() const { return abort_reason_ != AbortReason::none || is_last_step(); }
  /// The events since the last call.
  std::vector<ExecutiveEvent> take_events();

 private:
  void observe(const Observation& observation);
  std::optional<NodeSighting> node_told(const Observation& observation);
  void smooth_velocity(const Observation& observation);
  Situation assess(const Observation& observation, bool on_ground);
  void enter(Phase phase, const Observation& observation);
  void pass_node(Time now);
  Command command(const Observation& observation);
  Command shape(const Command& command, const Observation& observation, double dt_s);

  VelocityCommand climb(const Observation& observation) const;
  VelocityCommand stay(const Observation& observation, double yaw_rate_rad_s = 0.0) const;
  Command align(const Observation& observation);
  Command follow(const Observation& observation);
  Command follow_at(const Observation& observation, double speed_m_s, bool curved);
  double heading_hold_rad_s() const;
  VelocityCommand hold_node(const Observation& observation);
  Command hover(const Observation& observation);
  Command land(const Observation& observation);
  VelocityCommand relaunch(const Observation& observation);
  VelocityCommand corner(const Observation& observation);
  VelocityCommand turn(const Observation& observation);

  double approach_speed(const Observation& observation) const;
  CornerArc planned_arc() const;
  CornerArc arc_from_here(const Observation& observation) const;
  std::optional<CornerPath> corner_path(const Observation& observation) const;
  std::optional<double> stop_ahead_m(const Observation& observation) const;
  double turn_left(const Observation& observation) const;
  Eigen::Vector2d node_drift_H_m_s(const Observation& observation) const;
  bool has_landed() const;
  bool is_last_step() const { return step_ + 1 >= plan_.steps.size(); }
  Turn turn_in(Phase phase, const Observation& observation) const;
  const PlanStep* current_step() const;
  void report(std::string kind, std::string detail);

  Plan plan_;
  std::unique_ptr<FollowLaw> law_;
  LawTraits traits_;
  ExecutiveOptions options_;
  DockLaw dock_law_;
  JunctionMatcher matcher_;
  NodeTracker tracker_;
  CentroidBend centroid_bend_;

  Phase phase_ = Phase::take_off;
  AbortReason abort_reason_ = AbortReason::none;
  std::size_t step_ = 0;
  int nodes_recognised_ = 0;
  std::optional<NodeSighting> node_;  ///< told in this tick
  Time phase_began_{0};
  Time goal_began_{0};  ///< since when the phase's goal holds
  bool goal_held_ = false;
  Time line_seen_{0};
  std::optional<double> line_angle_rad_, line_offset_m_;  ///< of the line to follow, now
  double travelled_m_ = 0.0;  ///< forward: swaying from side to side brings no node nearer
  Time node_passed_{0};       ///< or the start of the leg
  std::optional<Motion> last_odometry_;
  Eigen::Vector2d velocity_H_m_s_ = Eigen::Vector2d::Zero();  ///< averaged, drift included over a node
  Turn turn_;
  Lookout lookout_;
  CornerArc arc_;  ///< of the corner that is being flown
  VelocityCommand last_command_;
  std::optional<Time> last_tick_;
  std::vector<ExecutiveEvent> events_;
};

}  // namespace lineservo::servo
