#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "servo/plan/plan.h"

namespace lineservo::servo {

/// Probabilities of what is told of a node, and how well the lengths of edges are known.
struct WhereaboutsOptions {
  double length_tolerance = 0.2;  ///< of an edge's length: beyond, a node there is not believed
  double length_slack_m = 0.6;
  double told_right = 0.9;     ///< of the nodes passed, told by their own code
  double told_wrong = 0.03;    ///< told by any other given code
  double missed = 0.02;        ///< not told at all
  double ghost = 0.002;        ///< told where no node is
  double turned_wrong = 0.01;  ///< ended a turn on any other given arm
  double misfit = 1e-3;        ///< came at a distance that no edge has
  double elsewhere = 1e-3;     ///< at the start: the vehicle was put down on any other edge
};

/// Which edge the vehicle flies along, from the codes that it passed and the turns that it made: a histogram
/// filter over the arms of the topological graph. An edge's length says no more than whether a node can have
/// come already or must have come. Knows no coordinates.
class Whereabouts {
 public:
  /// One arm of a node, that is an edge and the direction of travel.
  struct Arm {
    std::size_t node = 0, arm = 0;
    friend auto operator<=>(const Arm&, const Arm&) = default;
  };
  /// The way since the call before, as surely as it is known.
  struct Way {
    double at_least_m = 0.0, at_most_m = 0.0;
  };
  /// One place where the vehicle may be.
  struct Belief {
    Arm arm;               ///< flown along
    bool on_node = false;  ///< at its end; otherwise on the way there
    double probability = 0.0;
  };

  /// Nothing is known, and nothing will be.
  Whereabouts() = default;
  Whereabouts(std::shared_ptr<const Topology> floor, const Arm& start,
              const WhereaboutsOptions& options = {});

  /// A node was told.
  void tell(const NodeSignature& seen, const Way& way);
  /// The vehicle went on from where it was told a node, turning by so much.
  void leave(double turn_rad);

  /// What is most likely; none when nothing is known.
  std::optional<Belief> best() const;
  /// How likely it is that the vehicle is at a node of this name.
  double on_node(std::string_view node) const;
  const TopologyArm& arm(const Arm& a) const { return floor_->nodes[a.node].arms[a.arm]; }
  const Topology* floor() const { return floor_.get(); }

 private:
  struct Hypothesis {
    Arm arm;
    bool on_node = false;
    double weight = 0.0;
    Way along;  ///< since the arm's beginning
  };
  void reach(const Hypothesis& h, const NodeSignature& seen, double weight, int may_miss,
             std::vector<Hypothesis>& reached) const;
  double likelihood(const TopologyArm& by, const NodeSignature& seen) const;
  std::optional<Arm> onward(const TopologyArm& by, double turn_rad) const;
  void go_on(const Hypothesis& h, double turn_rad, std::vector<Hypothesis>& left) const;
  void normalise();

  std::shared_ptr<const Topology> floor_;
  WhereaboutsOptions options_;
  std::vector<Hypothesis> hypotheses_;
};

}  // namespace lineservo::servo
