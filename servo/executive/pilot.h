#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "servo/executive/executive_options.h"
#include "servo/executive/search.h"
#include "servo/executive/turn.h"
#include "servo/law/follow_law.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {

/// What the executive has decided, for one tick.
struct Orders {
  Phase phase = Phase::take_off;
  const PlanStep* step = nullptr;  ///< what is expected next or being carried out
  bool leaving = false;            ///< the node behind is still in view
  bool keeps_landed = false;       ///< at the end of the flight it stays on the ground
};

/// Flies what the executive has decided: keeps the line and the node to go by in mind, and turns a phase into
/// a command.
class Pilot {
 public:
  Pilot(std::unique_ptr<FollowLaw> law, const LawTraits& traits, const ExecutiveOptions& options);

  /// Takes in the line to follow. False when the frame shows none.
  bool see_line(const Observation& observation);
  /// Takes in where the node was in the frame, if it was; `goes_by_it`: the phase is about this node.
  void see_node(const Observation& observation, const std::optional<Eigen::Vector2d>& sighting_m,
                bool goes_by_it);
  /// The vehicle stands facing its first edge: a line across the heading is another. When the edge does not
  /// hold still, because what the marker leaves of it is worn, the vehicle goes a little ahead of the marker.
  void see_first_edge(const Observation& observation);
  /// In a turn the next edge's line counts, where the frame shows it.
  void see_turn(const Observation& observation) { line_angle_rad_ = turn_.correct(observation); }
  void forget_node() { tracker_.reset(); }
  /// Makes ready for a phase that follows another.
  void change(Phase from, const Orders& orders, const Observation& observation);

  /// Sets out to look for a line or node that went out of sight, counting its attempts here from 0.
  void begin_search(int attempt, Time now) { search_ = Search(last_line_, attempt, now); }
  bool search_is_over(Time now) const { return search_.is_over(now); }
  /// Since when the law has said what is not finite; none when it does not.
  const std::optional<Time>& refuses_since() const { return refuses_since_; }

  Command fly(const Orders& orders, const Observation& observation, double dt_s);

  bool looks_ahead() const { return looks_ahead_; }
  const std::optional<double>& line_angle_rad() const { return line_angle_rad_; }
  const std::optional<double>& line_offset_m() const { return line_offset_m_; }
  std::optional<Eigen::Vector2d> node_now(const Observation& observation) const {
    return tracker_.node_now(observation);
  }
  /// The motion that the velocity estimate does not know of, as learnt over a node.
  Eigen::Vector2d drift_H_m_s(const Observation& observation) const {
    return dock_law_.drift_H_m_s(observation);
  }
  /// The same node as it was when the frame was taken.
  std::optional<Eigen::Vector2d> node_at_capture(const Observation& observation) const {
    return tracker_.node_at_capture(observation);
  }
  /// Of the dead reckoning, with which the turn began.
  double heading_in_rad() const { return turn_.heading_in_rad(); }
  double turn_left_rad(const Observation& observation) const { return turn_.left_rad(observation); }
  /// The turn that comes can be flown without a stop.
  bool rounds_corner(const PlanStep* step, const Observation& observation) const;
  /// The way along the corner that is being flown, from the middle of its arc; none without its node.
  std::optional<double> corner_way_m(const Observation& observation) const;
  bool past_corner(const Observation& observation) const;
  /// The direction of the last velocity command, of unit length; zero at rest.
  Eigen::Vector2d flies_towards_H() const;

 private:
  Command command(const Orders& orders, const Observation& observation);
  Command shape(const Command& command, const Observation& observation, double dt_s);

  VelocityCommand climb(const Observation& observation) const;
  VelocityCommand stay(const Observation& observation, double yaw_rate_rad_s = 0.0) const;
  Command align(const Observation& observation);
  Command follow(const Orders& orders, const Observation& observation);
  /// `step`: whose edge is followed; none: a straight one.
  Command follow_at(const Observation& observation, double speed_m_s, const PlanStep* step);
  double heading_hold_rad_s() const;
  VelocityCommand hold_node(const Observation& observation,
                            const Eigen::Vector2d& from_it_H_m = Eigen::Vector2d::Zero());
  Command hover(const Observation& observation);
  Command land(const Observation& observation);
  VelocityCommand relaunch(const Observation& observation);
  Turn turn_in(const Orders& orders, const Observation& observation) const;
  VelocityCommand sink(const Observation& observation) const;
  VelocityCommand corner(const Observation& observation);
  VelocityCommand turn(const Observation& observation);
  VelocityCommand search(const Observation& observation);

  double approach_speed(const Orders& orders, const Observation& observation) const;
  CornerArc planned_arc(const PlanStep* step) const;
  CornerArc arc_from_here(const PlanStep* step, const Observation& observation) const;
  std::optional<CornerPath> corner_path(const Observation& observation) const;
  std::optional<double> stop_ahead_m(const Orders& orders, const Observation& observation) const;

  std::unique_ptr<FollowLaw> law_;
  LawTraits traits_;
  ExecutiveOptions options_;
  DockLaw dock_law_;
  NodeTracker tracker_;
  std::optional<double> line_angle_rad_, line_offset_m_;  ///< of the line to follow, now
  std::optional<LastLine> last_line_;
  Search search_;
  Time align_began_{0};
  bool looks_ahead_ = false;  ///< ahead of the marker for the first edge
  Turn turn_;
  CornerArc arc_;  ///< of the corner that is being flown
  VelocityCommand last_command_;
  std::optional<Time> refuses_since_;
};

/// Phases that change the heading from one edge to the next, or to the same again.
constexpr bool turns(Phase phase) {
  return phase == Phase::turn || phase == Phase::corner || phase == Phase::look;
}

}  // namespace lineservo::servo
