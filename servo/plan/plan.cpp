#include "servo/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "servo/plan/dif.h"
#include "servo/plan/route.h"

namespace lineservo::servo {
namespace {

using features::Arms;
using features::JunctionCode;
using features::kPi;
using features::wrap_angle;

constexpr double kArmTolerance_rad = features::radians(25.0);      // codes.md
constexpr double kStraightOn_rad = features::radians(15.0);        // beyond, the camera may see a corner
constexpr double kSharpestBend_rad = kPi / 2 - kArmTolerance_rad;  // beyond, it is a corner
constexpr NodeSignature kDisc{JunctionCode::start, JunctionCode::start, false, Bend::none};

bool near(double angle_rad, double direction_rad) {
  return std::abs(wrap_angle(angle_rad - direction_rad)) <= kArmTolerance_rad;
}

std::string in_degrees(double angle_rad) {
  return std::to_string(std::lround(features::degrees(angle_rad))) + "°";
}

/// The arm that lies in this direction to the way.
bool& side_of(Arms& arms, double angle_rad) {
  if (near(angle_rad, 0.0)) return arms.forward;
  if (near(angle_rad, kPi)) return arms.back;
  if (near(angle_rad, kPi / 2)) return arms.left;
  if (near(angle_rad, -kPi / 2)) return arms.right;
  throw std::invalid_argument(
      "an arm at " + in_degrees(angle_rad) +
      " to the way is none that the junction codes can name (forward, back, left, right)");
}

void add_arm(Arms& arms, double angle_rad) {
  bool& side = side_of(arms, angle_rad);
  if (side) {
    throw std::invalid_argument(
        "the arm at " + in_degrees(angle_rad) +
        " to the way is one of two on the same side: the camera cannot tell them apart "
        "(allowed is one each forward, back, left and right, within 25°)");
  }
  side = true;
}

std::vector<double> relative_angles(const TopologyNode& node, double travel_heading_rad) {
  std::vector<double> angles;
  for (const TopologyArm& arm : node.arms) angles.push_back(wrap_angle(arm.heading_rad - travel_heading_rad));
  return angles;
}

bool looks_like_plain_line(const NodeSignature& s) {
  return s.code == JunctionCode::straight && !s.line_ends && s.bend == Bend::none;
}

Bend bend_of(const std::vector<double>& arm_angles_rad) {
  if (arm_angles_rad.size() != 2) return Bend::none;
  const bool first_is_back = near(arm_angles_rad[0], kPi);
  if (!first_is_back && !near(arm_angles_rad[1], kPi)) return Bend::none;
  const double bend_rad = wrap_angle(arm_angles_rad[first_is_back ? 1 : 0]);
  if (near(bend_rad, 0.0) || std::abs(bend_rad) >= kSharpestBend_rad) return Bend::none;
  return bend_rad > 0.0 ? Bend::left : Bend::right;
}

PlanStep arrive(const Topology& topology, const TopologyArm& by) {
  PlanStep step;
  step.node = topology.nodes[by.to].name;
  step.edge_length_m = topology.edges[by.edge].length_m;
  step.edge_bends = topology.edges[by.edge].bends;
  step.expected = signature_at(topology, by);
  return step;
}

/// The vehicle is put down facing the first edge: no other arm may pass for it.
void check_start(const Topology& topology, const TopologyArm& first) {
  const TopologyNode& start = topology.nodes[topology.start];
  for (const TopologyArm& arm : start.arms) {
    const double apart_rad = wrap_angle(arm.heading_rad - first.heading_rad);
    const bool is_itself = arm.edge == first.edge && apart_rad == 0.0;
    if (is_itself || !near(apart_rad, 0.0)) continue;
    throw std::invalid_argument("node " + start.name + ": two lines leave it only " +
                                in_degrees(std::abs(apart_rad)) +
                                " apart: the camera cannot tell them apart (allowed is more than 25°)");
  }
}

void check_corners(const Topology& topology, const TopologyArm& by, const std::string& from) {
  const double corner_rad = topology.edges[by.edge].sharpest_corner_rad;
  if (corner_rad <= kStraightOn_rad) return;
  throw std::invalid_argument("the line from " + from + " to " + topology.nodes[by.to].name + " turns by " +
                              in_degrees(corner_rad) +
                              " at once: allowed between nodes are 15°; put a node there");
}

void leave(PlanStep& step, const TopologyArm& by, const TopologyArm& onto) {
  const double turn_rad = wrap_angle(onto.heading_rad - by.arrival_heading_rad);
  if (std::abs(turn_rad) <= kStraightOn_rad) return;
  if (near(turn_rad, 0.0)) {
    throw std::invalid_argument("node " + step.node + ": the way bends by " + in_degrees(std::abs(turn_rad)) +
                                ", neither straight on (up to 15°) nor a bend or turn (from 25°)");
  }
  if (looks_like_plain_line(step.expected)) {
    throw std::invalid_argument("node " + step.node +
                                ": the way turns where the camera sees only plain line");
  }
  step.manoeuvre = Manoeuvre::turn;
  step.turn_rad = turn_rad;
}

/// Edges since the last step whose end the camera cannot tell.
struct UnseenEdges {
  double length_m = 0.0;
  bool bend = false;
};

/// Nodes that the camera cannot tell and that ask for nothing are driven over: their edges go to the next
/// step.
void append(std::vector<PlanStep>& steps, PlanStep step, UnseenEdges& unseen) {
  step.edge_length_m += unseen.length_m;
  step.edge_bends |= unseen.bend;
  if (step.manoeuvre == Manoeuvre::go_straight && looks_like_plain_line(step.expected)) {
    unseen = {step.edge_length_m, step.edge_bends};
    return;
  }
  unseen = {};
  steps.push_back(std::move(step));
}

/// One round to the start's own disc, where nothing but the line that is flown passes.
bool ends_a_round(const TopologyNode& start) {
  const auto& arms = start.arms;
  return start.has_disc && arms.size() == 2 && near(arms[0].heading_rad - arms[1].heading_rad, kPi);
}

/// The steps of the plan's route, which leaves `from`.
void add_steps(Plan& plan, const Topology& topology, std::size_t from) {
  const Route& route = plan.route;
  UnseenEdges unseen;
  for (std::size_t k = 0; k < route.size(); ++k) {
    check_corners(topology, route[k], topology.nodes[k == 0 ? from : route[k - 1].to].name);
    PlanStep step = arrive(topology, route[k]);
    if (k + 1 < route.size()) {
      leave(step, route[k], route[k + 1]);
    } else if (looks_like_plain_line(step.expected)) {
      throw std::invalid_argument(plan.instruction + ": the camera cannot tell " + plan.target +
                                  " from plain line");
    } else {
      step.manoeuvre = Manoeuvre::hover;
    }
    append(plan.steps, std::move(step), unseen);
  }
}

std::string labels_of(const Topology& topology) {
  std::string list;
  for (const auto& [label, node] : topology.labels) list += (list.empty() ? "" : " ") + label;
  return list.empty() ? "none: use node:NAME" : list;
}

}  // namespace

NodeSignature signature(const std::vector<double>& arm_angles_rad) {
  if (const Bend bend = bend_of(arm_angles_rad); bend != Bend::none) {
    return {JunctionCode::straight, JunctionCode::straight, false, bend};
  }
  Arms arms;
  for (const double angle_rad : arm_angles_rad) add_arm(arms, angle_rad);
  Arms ahead = arms;
  ahead.forward = false;  // the forward arm comes into view last
  return {code_of(ahead), code_of(arms), !arms.forward, Bend::none};
}

Plan compile(const Topology& topology, std::size_t target, std::string instruction) {
  const std::string& target_name = topology.nodes.at(target).name;
  if (target == topology.start && !ends_a_round(topology.nodes[target])) {
    throw std::invalid_argument(
        instruction + ": the target " + target_name +
        " is the take-off point itself (allowed where it is a disc on plain line: one round)");
  }
  const std::optional<Route> route = shortest_route(topology, topology.start, target);
  if (!route) throw std::invalid_argument(instruction + ": no painted way leads to " + target_name);

  Plan plan{std::move(instruction), target_name, route->front().heading_rad, {}, *route, {}};
  check_start(topology, route->front());
  add_steps(plan, topology, topology.start);
  plan.floor = std::make_shared<const Topology>(topology);
  return plan;
}

Plan compile_onward(std::shared_ptr<const Topology> topology, const TopologyArm& by, std::size_t target,
                    std::string instruction) {
  Plan plan{
      std::move(instruction), topology->nodes.at(target).name, by.arrival_heading_rad, {}, {by}, topology};
  if (by.to != target) {
    const std::optional<Route> onward = shortest_route(*topology, by.to, target);
    if (!onward)
      throw std::invalid_argument(plan.instruction + ": no painted way leads on to " + plan.target);
    plan.route.insert(plan.route.end(), onward->begin(), onward->end());
  }
  add_steps(plan, *topology, by.to);
  return plan;
}

NodeSignature signature_at(const Topology& topology, const TopologyArm& by) {
  const TopologyNode& node = topology.nodes[by.to];
  try {
    const NodeSignature seen = signature(relative_angles(node, by.arrival_heading_rad));
    return node.has_disc ? kDisc : seen;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("node " + node.name + ": " + error.what());
  }
}

std::size_t find_target(const Topology& topology, std::string_view target) {
  constexpr std::string_view kNodePrefix = "node:";
  if (target.starts_with(kNodePrefix)) {
    const std::string_view wanted = target.substr(kNodePrefix.size());
    for (std::size_t node = 0; node < topology.nodes.size(); ++node) {
      if (topology.nodes[node].name == wanted) return node;
    }
    throw std::invalid_argument("layout " + topology.name + " has no node '" + std::string(wanted) + "'");
  }
  const std::string label = to_string(parse_dif(target));
  const auto it = topology.labels.find(label);
  if (it == topology.labels.end()) {
    throw std::invalid_argument("layout " + topology.name + " has no target " + label +
                                "; it has: " + labels_of(topology));
  }
  return it->second;
}

std::string_view name(Bend bend) {
  return bend == Bend::left ? "bend left" : bend == Bend::right ? "bend right" : "no bend";
}

std::string_view name(Manoeuvre manoeuvre) {
  switch (manoeuvre) {
    case Manoeuvre::go_straight:
      return "go straight";
    case Manoeuvre::turn:
      return "turn";
    case Manoeuvre::hover:
      return "hover";
  }
  return "?";
}

}  // namespace lineservo::servo
