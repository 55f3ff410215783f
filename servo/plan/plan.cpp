#include "servo/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <optional>
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
constexpr double kOneLine_rad = features::radians(16.0);
constexpr double kTwoLines_rad = features::radians(22.0);
constexpr double kForkApart_rad = features::radians(40.0);  // arms of a fork, as seen, are less sure

bool near(double angle_rad, double direction_rad) {
  return std::abs(wrap_angle(angle_rad - direction_rad)) <= kArmTolerance_rad;
}

std::string in_degrees(double angle_rad) {
  return std::to_string(std::lround(features::degrees(angle_rad))) + "°";
}

std::string in_metres(double length_m) {
  return std::to_string(0.01 * static_cast<double>(std::lround(100.0 * length_m))).substr(0, 4) + " m";
}

/// The arm that lies in this direction to the way; none when the codes have no name for it.
bool* side_of(Arms& arms, double angle_rad) {
  if (near(angle_rad, 0.0)) return &arms.forward;
  if (near(angle_rad, kPi)) return &arms.back;
  if (near(angle_rad, kPi / 2)) return &arms.left;
  if (near(angle_rad, -kPi / 2)) return &arms.right;
  return nullptr;
}

/// The arms as the codes name them; none when one has no name, or two have the same.
std::optional<Arms> named_arms(const std::vector<double>& arm_angles_rad) {
  Arms arms;
  for (const double angle_rad : arm_angles_rad) {
    bool* side = side_of(arms, angle_rad);
    if (!side || *side) return std::nullopt;
    *side = true;
  }
  return arms;
}

/// The smallest angle between two of a fork's arms.
double least_apart_rad(const std::vector<double>& arm_angles_rad) {
  double least_rad = 2.0 * kPi;
  for (std::size_t i = 0; i < arm_angles_rad.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      least_rad = std::min(least_rad, std::abs(wrap_angle(arm_angles_rad[i] - arm_angles_rad[j])));
  }
  return least_rad;
}

/// Two arms that lead away from the way, nearly in one line with each other: seen as one stripe or as two.
void check_axes(const std::vector<double>& arm_angles_rad) {
  for (const double a_rad : arm_angles_rad) {
    for (const double b_rad : arm_angles_rad) {
      const double off_rad = kPi - std::abs(wrap_angle(a_rad - b_rad));
      const bool is_way = near(a_rad, kPi) || near(b_rad, kPi);
      if (is_way || off_rad < kOneLine_rad || off_rad > kTwoLines_rad) continue;
      throw std::invalid_argument("its arms at " + in_degrees(a_rad) + " and " + in_degrees(b_rad) + " lie " +
                                  in_degrees(off_rad) +
                                  " off one line: the camera cannot tell one line from two (allowed is up to "
                                  "16°, or from 22°)");
    }
  }
}

NodeSignature fork(const std::vector<double>& arm_angles_rad) {
  const double apart_rad = least_apart_rad(arm_angles_rad);
  if (apart_rad < kForkApart_rad) {
    throw std::invalid_argument(
        "two of its arms are only " + in_degrees(apart_rad) +
        " apart, where the junction codes have no name for them (forward, back, left, "
        "right, within 25°): the camera cannot tell them apart (allowed is 40°)");
  }
  check_axes(arm_angles_rad);
  NodeSignature signature{JunctionCode::straight, JunctionCode::straight, false, Bend::fork, arm_angles_rad};
  std::sort(signature.arms_rad.begin(), signature.arms_rad.end());
  return signature;
}

// Borders of lines of the width w that leave a node δ apart part w/2 / tan(δ/2) from it.
void check_view(const Topology& topology, const TopologyNode& node) {
  constexpr double kSeen = 0.6;  // of the view: the rest shows the arms
  const double farthest_m = kSeen * topology.view_m;
  for (const TopologyArm& a : node.arms) {
    for (const TopologyArm& b : node.arms) {
      const double apart_rad = std::abs(wrap_angle(a.heading_rad - b.heading_rad));
      const double width_m = std::max(a.width_m, b.width_m);
      const double part_m = 0.5 * width_m / std::tan(0.5 * apart_rad);
      if (&a == &b || part_m <= farthest_m) continue;
      throw std::invalid_argument("lines " + in_metres(width_m) + " wide leave it " + in_degrees(apart_rad) +
                                  " apart and part " + in_metres(part_m) +
                                  " from it: the camera cannot tell them apart from its height (allowed is " +
                                  in_metres(farthest_m) + "; fly higher or paint narrower)");
    }
  }
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

/// The vehicle is put down, or turns, facing the first edge: no other arm may pass for it.
void check_first_edge(const TopologyNode& start, const TopologyArm& first) {
  for (const TopologyArm& arm : start.arms) {
    const double apart_rad = wrap_angle(arm.heading_rad - first.heading_rad);
    const bool is_itself = arm.edge == first.edge && apart_rad == 0.0;
    if (is_itself || !near(apart_rad, 0.0)) continue;
    throw std::invalid_argument("node " + start.name + ": two lines leave it only " +
                                in_degrees(std::abs(apart_rad)) +
                                " apart: the camera cannot tell them apart (allowed is more than 25°)");
  }
}

// The cap of a broad line that ends below the vehicle fills the view: no two borders of it are long enough.
void check_take_off(const Topology& topology) {
  constexpr double kBroadest = 0.9;  // of the view ahead
  const TopologyNode& start = topology.nodes[topology.start];
  const bool is_dead_end = start.arms.size() == 1 && !start.has_disc;
  if (!is_dead_end || start.arms[0].width_m <= kBroadest * topology.view_m) return;
  throw std::invalid_argument(
      "node " + start.name + ": from its height the camera cannot tell the end of a line " +
      in_metres(start.arms[0].width_m) + " wide from any other paint (allowed up to " +
      in_metres(kBroadest * topology.view_m) + "): lay a red disc (marker_radius_m), or fly higher");
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
  if (near(turn_rad, 0.0) && step.expected.bend != Bend::fork) {
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
void append(PlanStep step, std::vector<PlanStep>& steps, UnseenEdges& unseen) {
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

void check_leads_on(const Topology& topology, std::size_t from, const Visit& visit, bool begins) {
  if (visit.node != from || ends_a_round(topology.nodes[from])) return;
  throw std::invalid_argument(visit.target + ": the target " + topology.nodes[from].name +
                              (begins ? " is the take-off point itself" : " is where the target before is") +
                              " (allowed where it is a disc on plain line: one round)");
}

PlanStep arrive_at_target(const Topology& topology, const TopologyArm& by, const Visit& visit) {
  PlanStep step = arrive(topology, by);
  if (looks_like_plain_line(step.expected))
    throw std::invalid_argument(visit.target + ": the camera cannot tell " + step.node + " from plain line");
  step.manoeuvre = Manoeuvre::hover;
  step.target = visit.target;
  step.stop = visit.stop;
  return step;
}

/// The steps along a route to a target.
std::vector<PlanStep> leg(const Topology& topology, std::size_t from, const Route& route,
                          const Visit& visit) {
  std::vector<PlanStep> steps;
  UnseenEdges unseen;
  for (std::size_t k = 0; k + 1 < route.size(); ++k) {
    check_corners(topology, route[k], topology.nodes[k == 0 ? from : route[k - 1].to].name);
    PlanStep step = arrive(topology, route[k]);
    leave(step, route[k], route[k + 1]);
    append(std::move(step), steps, unseen);
  }
  check_corners(topology, route.back(),
                topology.nodes[route.size() < 2 ? from : route[route.size() - 2].to].name);
  append(arrive_at_target(topology, route.back(), visit), steps, unseen);
  return steps;
}

std::string labels_of(const Topology& topology) {
  std::string list;
  for (const auto& [label, node] : topology.labels) list += (list.empty() ? "" : " ") + label;
  return list.empty() ? "none: use node:NAME" : list;
}

}  // namespace

NodeSignature signature(const std::vector<double>& arm_angles_rad) {
  if (const Bend bend = bend_of(arm_angles_rad); bend != Bend::none) {
    return {JunctionCode::straight, JunctionCode::straight, false, bend, {}};
  }
  const std::optional<Arms> arms = named_arms(arm_angles_rad);
  if (!arms) return fork(arm_angles_rad);
  Arms ahead = *arms;
  ahead.forward = false;  // the forward arm comes into view last
  return {code_of(ahead), code_of(*arms), !arms->forward, Bend::none, {}};
}

std::vector<std::size_t> target_steps(const Plan& plan) {
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < plan.steps.size(); ++k) {
    if (plan.steps[k].manoeuvre == Manoeuvre::hover) indices.push_back(k);
  }
  return indices;
}

PlanBuilder::PlanBuilder(const Topology& topology, std::string instruction) : topology_(topology) {
  plan_.instruction = std::move(instruction);
  plan_.floor = std::make_shared<const Topology>(topology);
}

std::size_t PlanBuilder::here() const {
  return plan_.route.empty() ? topology_.start : plan_.route.back().to;
}

void PlanBuilder::visit(const Visit& visit) {
  const bool begins = plan_.route.empty();
  check_leads_on(topology_, here(), visit, begins);
  const auto facing_rad = begins ? std::nullopt : std::optional(plan_.route.back().arrival_heading_rad);
  const std::optional<Route> route = shortest_route(topology_, here(), visit.node, facing_rad);
  const std::string& name = topology_.nodes[visit.node].name;
  if (!route) throw std::invalid_argument(visit.target + ": no painted way leads to " + name);
  if (begins) check_take_off(topology_);
  check_first_edge(topology_.nodes[here()], route->front());
  std::vector<PlanStep> steps = leg(topology_, here(), *route, visit);
  if (begins) plan_.start_heading_rad = route->front().heading_rad;
  if (!begins) plan_.steps.back().turn_rad = wrap_angle(route->front().heading_rad - *facing_rad);
  plan_.target = name;
  plan_.steps.insert(plan_.steps.end(), steps.begin(), steps.end());
  plan_.route.insert(plan_.route.end(), route->begin(), route->end());
}

Plan compile(const Topology& topology, std::size_t target, std::string instruction) {
  PlanBuilder builder(topology, instruction);
  builder.visit({target, std::move(instruction), {}});
  return builder.plan();
}

Plan compile_onward(std::shared_ptr<const Topology> topology, const TopologyArm& by, const Visit& visit,
                    std::string instruction) {
  Plan plan;
  plan.instruction = std::move(instruction);
  plan.target = topology->nodes.at(visit.node).name;
  plan.start_heading_rad = by.arrival_heading_rad;
  plan.route = {by};
  plan.floor = topology;
  if (by.to != visit.node) {
    const auto onward = shortest_route(*topology, by.to, visit.node, by.arrival_heading_rad);
    if (!onward)
      throw std::invalid_argument(plan.instruction + ": no painted way leads on to " + plan.target);
    plan.route.insert(plan.route.end(), onward->begin(), onward->end());
  }
  plan.steps = leg(*topology, by.to, plan.route, visit);
  return plan;
}

NodeSignature signature_at(const Topology& topology, const TopologyArm& by) {
  const TopologyNode& node = topology.nodes[by.to];
  const NodeSignature disc{JunctionCode::start, JunctionCode::start, false, Bend::none, {}};
  try {
    const NodeSignature seen = signature(relative_angles(node, by.arrival_heading_rad));
    if (seen.bend == Bend::fork) check_view(topology, node);
    return node.has_disc ? disc : seen;
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
  switch (bend) {
    case Bend::none:
      return "no bend";
    case Bend::left:
      return "bend left";
    case Bend::right:
      return "bend right";
    case Bend::fork:
      return "fork";
  }
  return "?";
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
