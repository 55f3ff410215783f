#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "servo/executive/executive_options.h"
#include "servo/executive/junction_matcher.h"
#include "servo/executive/leg_compass.h"
#include "servo/executive/lookout.h"
#include "servo/executive/navigator.h"
#include "servo/executive/observation_guard.h"
#include "servo/executive/pilot.h"
#include "servo/executive/sighting.h"
#include "servo/law/follow_law.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {

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
  /// `on_ground`: the autopilot has landed. Whatever the observation holds, the command is finite.
  Command tick(const Observation& observation, bool on_ground);

  Phase phase() const { return phase_; }
  AbortReason abort_reason() const { return abort_reason_; }
  /// Index of the plan's step that is expected next or being carried out.
  std::size_t step() const { return navigator_.index(); }
  /// How many nodes of the plan were recognised as expected.
  int nodes_recognised() const { return nodes_recognised_; }
  /// That in force: the codes may have called for another than the one given.
  const Plan& plan() const { return navigator_.plan(); }
  /// A landing now is the end of the flight: no target comes after it, or the flight was broken off.
  bool ends_on_ground() const { return abort_reason_ != AbortReason::none || is_last_step(); }
  /// The events since the last call.
  std::vector<ExecutiveEvent> take_events();

 private:
  void observe(const Observation& observation);
  void note_progress(Time now);
  double along_way_m(const Eigen::Vector2d& moved_H_m) const;
  std::optional<NodeSighting> node_told(const Observation& observation);
  void smooth_velocity(const Observation& observation);
  Situation assess(const Observation& observation, bool on_ground);
  void enter(Phase phase, const Observation& observation);
  const Observation& keep_straight(const Observation& observation);
  void judge_node(const Observation& observation);
  void pass_node(Time now);
  void begin_search(Phase from, const Observation& observation);
  void assess_health(const Observation& observation, Situation& s) const;
  Command decide(const Observation& observation, bool on_ground);
  void begin_leg(Phase from, const Observation& observation);
  Orders orders() const;

  Eigen::Vector2d node_drift_H_m_s(const Observation& observation) const;
  bool has_landed() const;
  bool is_last_step() const { return navigator_.index() + 1 >= plan().steps.size(); }
  const PlanStep* current_step() const { return navigator_.step(); }
  /// The law leads along the line by itself, whatever the heading.
  bool pursues() const;
  void report(std::string kind, std::string detail);

  ObservationGuard guard_;
  Navigator navigator_;
  LawTraits traits_;
  ExecutiveOptions options_;
  Pilot pilot_;
  JunctionMatcher matcher_;
  CentroidBend centroid_bend_;
  LegCompass compass_;
  Observation reordered_;  ///< with the line that goes straight on before the others
  Lookout lookout_;

  Phase phase_ = Phase::take_off;
  AbortReason abort_reason_ = AbortReason::none;
  int nodes_recognised_ = 0;
  std::optional<NodeSighting> node_;  ///< told in this tick
  bool node_puzzles_ = false;
  Time phase_began_{0};
  Time goal_began_{0};  ///< since when the phase's goal holds
  bool goal_held_ = false;
  Time line_seen_{0};
  double travelled_m_ = 0.0;  ///< forward: swaying from side to side brings no node nearer
  Time node_passed_{0};       ///< or the start of the leg
  double told_at_m_ = 0.0;    ///< of the way travelled, when the last node was told that is none of the plan
  Time told_at_{0};
  double advanced_m_ = 0.0;  ///< of the way travelled, at the last progress
  Time advanced_at_{0};
  Phase searched_from_ = Phase::follow;
  int searches_ = 0;  ///< about the same place
  Eigen::Vector2d searched_at_m_ = Eigen::Vector2d::Zero();
  std::optional<Motion> last_odometry_;
  Eigen::Vector2d velocity_H_m_s_ = Eigen::Vector2d::Zero();  ///< averaged, drift included over a node
  std::optional<Time> last_tick_;
  std::vector<ExecutiveEvent> events_;
};

}  // namespace lineservo::servo
