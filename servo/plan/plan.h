#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/junction/junction_code.h"
#include "servo/plan/route.h"

namespace lineservo::servo {

/// A node that the codes have no name for. A bend: the way turns by 25 to 65°, and no other arm is there. A
/// fork: arms at other angles than forward, back, left and right; it is told by the angles of all of them.
enum class Bend { none, left, right, fork };

std::string_view name(Bend bend);

/// How a node looks to the camera of a vehicle that approaches it.
struct NodeSignature {
  features::JunctionCode preview = features::JunctionCode::straight;  ///< when its side arms come into view
  features::JunctionCode code = features::JunctionCode::straight;     ///< when all its arms are in view
  bool line_ends = false;             ///< no arm goes on ahead: a corner, a ┬ or a dead end
  Bend bend = Bend::none;             ///< the code is that of plain line then
  std::vector<double> arms_rad = {};  ///< of a fork: of all its arms, from the way, counter-clockwise

  friend bool operator==(const NodeSignature&, const NodeSignature&) = default;
};

enum class Manoeuvre { go_straight, turn, hover };

/// What is done at a target, in this order.
struct Stop {
  std::optional<double> hover_s = {};  ///< none: as long as at the end of every flight
  bool look = false;                   ///< turns once about itself
  bool land = false;
  double ground_s = 0.0;  ///< stays on the ground so long before the next target
};

/// One node on the way: what is expected there and what to do.
struct PlanStep {
  NodeSignature expected;
  Manoeuvre manoeuvre = Manoeuvre::go_straight;
  double turn_rad = 0.0;       ///< for a turn, and after a hover that goes on; counter-clockwise
  double edge_length_m = 0.0;  ///< since the step before; for time-outs only
  std::string node;            ///< for explaining the plan only
  bool edge_bends = false;     ///< the edge since the step before is not straight
  bool pursued = false;        ///< the line leads to it whatever the heading; no code counts but its disc's
  std::string target = {};     ///< what it is called in the instruction; empty for a node on the way
  Stop stop = {};              ///< at a target
};

/// An instruction compiled to what the camera will see and what to do about it.
struct Plan {
  std::string instruction;
  std::string target;
  double start_heading_rad = 0.0;  ///< of the first edge; where the vehicle is placed facing
  std::vector<PlanStep> steps;     ///< targets hover; the last one is a target
  Route route;                     ///< the arms taken; for explaining and scoring only
  /// What it was compiled on, to find out by the codes where a flight has got to and to plan anew.
  std::shared_ptr<const Topology> floor = {};
};

/// Indices of the steps that are targets, in order; the last one is the plan's last.
std::vector<std::size_t> target_steps(const Plan& plan);

/// One target of a mission.
struct Visit {
  std::size_t node = 0;
  std::string target;  ///< what it is called, for messages
  Stop stop;
};

/// Compiles a mission target by target: each leg leaves the node where the last one ended, turning round
/// where it must.
class PlanBuilder {
 public:
  PlanBuilder(const Topology& topology, std::string instruction);

  /// Adds the way to one more target. Throws std::invalid_argument that says why, and adds nothing, when
  /// there is no route, when the target is where the vehicle stands already and not a disc on plain line
  /// (which is one round), when the camera cannot tell a node that matters (it looks like plain line), when
  /// arms of a fork are less than 40° apart or part beyond the camera's view, or when the way bends by 15 to
  /// 25° at once.
  void visit(const Visit& visit);
  const Plan& plan() const { return plan_; }

 private:
  std::size_t here() const;

  const Topology& topology_;
  Plan plan_;
};

/// The plan for a single target. Throws as PlanBuilder::visit().
Plan compile(const Topology& topology, std::size_t target, std::string instruction);

/// The plan of a traveller who has just come to the end of an arm. Throws as compile() does.
Plan compile_onward(std::shared_ptr<const Topology> topology, const TopologyArm& by, const Visit& visit,
                    std::string instruction);

/// The node that a target names: a DIF (a13) by the topology's labels, or node:NAME. Throws
/// std::invalid_argument with what is allowed.
std::size_t find_target(const Topology& topology, std::string_view target);

/// How a node with arms at these angles (relative to the direction of travel, back arm included) looks.
/// Two arms of which one lies back and one 25 to 65° off ahead are a bend. Arms more than 25° off forward,
/// back, left and right, or two on one side, make it a fork. Throws std::invalid_argument when two arms of a
/// fork are less than 40° apart.
NodeSignature signature(const std::vector<double>& arm_angles_rad);

/// How the node at the end of an arm looks to a traveller who comes along it. Throws as signature() does.
NodeSignature signature_at(const Topology& topology, const TopologyArm& by);

std::string_view name(Manoeuvre manoeuvre);

}  // namespace lineservo::servo
