#include "servo/executive/navigator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace lineservo::servo {
namespace {

constexpr double kDoubt = 0.5;  // below, the plan's own node is not where the codes say the vehicle is
constexpr double kSure = 0.8;   // from here on a belief is acted on
constexpr int kMostPlans = 6;
constexpr double kLengthTolerance = 0.2;

Whereabouts start_of(const Plan& plan) {
  const bool by_codes = plan.floor && !plan.route.empty() && !plan.steps.front().pursued;
  if (!by_codes) return {};
  const auto& arms = plan.floor->nodes[plan.floor->start].arms;
  const TopologyArm& first = plan.route.front();
  for (std::size_t k = 0; k < arms.size(); ++k) {
    if (arms[k].edge == first.edge && arms[k].heading_rad == first.heading_rad)
      return Whereabouts(plan.floor, {plan.floor->start, k});
  }
  return {};
}

NodeSignature signature_of(const NodeSighting& node) {
  return {node.code, node.code, node.line_ends, node.bend};
}

}  // namespace

Navigator::Navigator(Plan plan) : plan_(std::move(plan)), whereabouts_(start_of(plan_)) {}

Navigator::Verdict Navigator::judge(const NodeSighting& node, const Whereabouts::Way& way, bool in_time) {
  const bool is_end = node.line_ends && node.code == features::JunctionCode::straight;
  const bool ends_as_planned = step() && matches(node, step()->expected);
  if (is_end && !ends_as_planned) return Verdict::ignored;  // worn or painted over, for all that is known
  whereabouts_.tell(signature_of(node), way);
  const auto belief = whereabouts_.best();
  const bool expected = step() && in_time && matches(node, step()->expected);
  if (expected && (!belief || whereabouts_.on_node(step()->node) >= kDoubt)) return Verdict::as_planned;
  if (!belief) return Verdict::puzzling;
  const bool sure = belief->probability >= kSure;
  if (sure && belief->on_node && plan_anew(*belief)) return Verdict::planned_anew;
  if (node.line_ends) return Verdict::puzzling;
  whereabouts_.leave(0.0);
  return Verdict::ignored;
}

bool Navigator::plan_anew(const Whereabouts::Belief& belief) try {
  const bool has_one_target = target_steps(plan_).size() == 1;
  if (plans_made_ >= kMostPlans || !has_one_target) return false;
  const auto& nodes = plan_.floor->nodes;
  const auto target = std::ranges::find(nodes, plan_.target, &TopologyNode::name);
  if (target == nodes.end()) return false;
  const PlanStep& last = plan_.steps.back();
  const Visit visit{static_cast<std::size_t>(target - nodes.begin()), last.target, last.stop};
  plan_ = compile_onward(plan_.floor, whereabouts_.arm(belief.arm), visit, plan_.instruction);
  step_ = 0;
  ++plans_made_;
  return true;
} catch (const std::invalid_argument&) {
  return false;  // no way leads on that the codes can tell
}

void Navigator::advance() {
  whereabouts_.leave(step() ? step()->turn_rad : 0.0);
  ++step_;
}

double Navigator::lost_limit_m() const {
  if (!plan_.floor || plan_.floor->edges.empty()) return 0.0;
  const auto longest = std::ranges::max_element(plan_.floor->edges, {}, &TopologyEdge::length_m);
  return (1.0 + kLengthTolerance) * longest->length_m;
}

std::string Navigator::place() const {
  const auto belief = whereabouts_.best();
  if (!belief) return "no floor to go by";
  const std::string node = plan_.floor->nodes[whereabouts_.arm(belief->arm).to].name;
  return (belief->on_node ? "at " : "before ") + node + " by the codes (" +
         std::to_string(std::lround(100.0 * belief->probability)) + " %)";
}

}  // namespace lineservo::servo
