#include "servo/plan/pursuit.h"

#include <algorithm>

namespace lineservo::servo {
namespace {

bool passes_branch(const Plan& plan, const Topology& topology) {
  return std::any_of(plan.route.begin(), plan.route.end(),
                     [&topology](const TopologyArm& arm) { return topology.nodes[arm.to].arms.size() > 2; });
}

}  // namespace

std::optional<Plan> pursuit_of(const Plan& plan, const Topology& topology) {
  const PlanStep& last = plan.steps.back();
  const bool ends_on_disc = last.expected.code == features::JunctionCode::start;
  if (!ends_on_disc || passes_branch(plan, topology) || target_steps(plan).size() > 1) return std::nullopt;
  PlanStep whole = last;
  whole.pursued = true;
  whole.edge_bends = true;
  whole.edge_length_m = 0.0;
  for (const TopologyArm& arm : plan.route) whole.edge_length_m += topology.edges[arm.edge].length_m;
  Plan pursuit = plan;
  pursuit.steps = {whole};
  return pursuit;
}

}  // namespace lineservo::servo
