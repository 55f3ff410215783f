// Every instruction that ships is compiled, and its plan is walked over the floor by what a vehicle can do
// without a map: go on ahead until a node looks as expected, then turn by the angle that the plan names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "apps/config/data_folder.h"
#include "apps/config/layout_file.h"
#include "apps/config/layout_topology.h"
#include "features/geometry/angles.h"
#include "servo/plan/plan.h"

namespace lineservo::apps {
namespace {

using features::JunctionCode;
using features::kPi;
using features::radians;
using features::wrap_angle;

servo::Topology topology_named(const std::string& layout) {
  return topology_of(read_layout(find_data(DataKind::layout, layout)));
}

servo::Plan plan_to(const servo::Topology& topology, const std::string& target) {
  return servo::compile(topology, servo::find_target(topology, target), target);
}

const servo::TopologyArm* arm_in_heading(const servo::TopologyNode& node, double heading_rad) {
  for (const servo::TopologyArm& arm : node.arms) {
    if (std::abs(wrap_angle(arm.heading_rad - heading_rad)) < radians(25.0)) return &arm;
  }
  return nullptr;
}

/// How a node looks in this heading, told from its arms without the planner's code.
struct Look {
  bool forward, left, right, disc;
  servo::Bend bend;
  bool is_plain() const { return forward && !left && !right && !disc; }
  bool ends() const { return !forward && !disc && bend == servo::Bend::none; }
  JunctionCode code() const {
    if (disc) return JunctionCode::start;
    if (forward)
      return left && right ? JunctionCode::cross : left ? JunctionCode::tee_left : JunctionCode::tee_right;
    if (left && right) return JunctionCode::tee_ahead;
    if (left) return JunctionCode::corner_left;
    return right ? JunctionCode::corner_right : JunctionCode::straight;
  }
};
Look look(const servo::TopologyNode& node, double heading_rad) {
  const auto sees = [&](double angle_rad) {
    return arm_in_heading(node, heading_rad + angle_rad) != nullptr;
  };
  servo::Bend bend = servo::Bend::none;
  if (node.arms.size() == 2 && sees(kPi / 4)) bend = servo::Bend::left;
  if (node.arms.size() == 2 && sees(-kPi / 4)) bend = servo::Bend::right;
  return {sees(0.0), sees(kPi / 2), sees(-kPi / 2), node.has_disc, bend};
}

/// Walks the plan; the node where it ends, or none when something did not look as the plan said.
std::optional<std::size_t> walk(const servo::Topology& topology, const servo::Plan& plan) {
  std::size_t at = topology.start;
  double heading_rad = plan.start_heading_rad;
  for (const servo::PlanStep& step : plan.steps) {
    Look seen{};
    do {
      const servo::TopologyArm* arm = arm_in_heading(topology.nodes[at], heading_rad);
      if (arm == nullptr) return std::nullopt;
      at = arm->to;
      heading_rad = arm->arrival_heading_rad;
      seen = look(topology.nodes[at], heading_rad);
    } while (seen.is_plain());
    if (seen.code() != step.expected.code || seen.ends() != step.expected.line_ends ||
        seen.bend != step.expected.bend)
      return std::nullopt;
    if (step.manoeuvre == servo::Manoeuvre::turn) heading_rad += step.turn_rad;
  }
  return at;
}

class EveryInstruction : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryInstruction, EndsOnItsNodeByCodesAndTurnsAlone) {
  const servo::Topology topology = topology_named(GetParam());
  for (const auto& [label, node] : topology.labels) {
    if (node == topology.start && label != "d00") {
      EXPECT_THROW(plan_to(topology, label), std::invalid_argument) << label;
      continue;
    }
    const servo::Plan plan = plan_to(topology, label);
    EXPECT_EQ(walk(topology, plan), node) << GetParam() << " " << label;
    EXPECT_EQ(plan.steps.back().manoeuvre, servo::Manoeuvre::hover) << label;
    EXPECT_EQ(plan.instruction, label);
    EXPECT_EQ(plan.target, topology.nodes[node].name);
  }
}

TEST_P(EveryInstruction, StepLengthsAddUpToTheRoute) {
  const servo::Topology topology = topology_named(GetParam());
  for (const auto& [label, node] : topology.labels) {
    if (node == topology.start && label != "d00") continue;
    const servo::Plan plan = plan_to(topology, label);
    double of_steps_m = 0.0, of_route_m = 0.0;
    for (const servo::PlanStep& step : plan.steps) of_steps_m += step.edge_length_m;
    for (const servo::TopologyArm& arm : plan.route) of_route_m += topology.edges[arm.edge].length_m;
    EXPECT_NEAR(of_steps_m, of_route_m, 1e-9) << label;
  }
}

std::vector<std::string> all_layouts() {
  ::setenv("LINESERVO_DATA", LINESERVO_TEST_DATA, 1);
  std::vector<std::string> names;
  for (const DataEntry& entry : list_data(DataKind::layout)) names.push_back(entry.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Layouts, EveryInstruction, ::testing::ValuesIn(all_layouts()),
                         [](const auto& param) {
                           std::string name = param.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

/// "J5>J9 left, J7>J3 straight, …": preview, code and what to do.
std::string told(const std::string& instruction) {
  std::string text;
  for (const servo::PlanStep& step : plan_to(topology_named("warehouse"), instruction).steps) {
    text += (text.empty() ? "" : ", ") + std::string(features::name(step.expected.preview)) + ">" +
            std::string(features::name(step.expected.code));
    text += step.manoeuvre == servo::Manoeuvre::hover  ? " hover"
            : step.manoeuvre == servo::Manoeuvre::turn ? (step.turn_rad > 0 ? " left" : " right")
                                                       : " straight";
  }
  return text;
}

// The three of data/README.md.
TEST(Instructions, A13TurnsLeftAtTheFirstTeeAndHoversOnTheThirdCross) {
  EXPECT_EQ(told("a13"), "J5>J9 left, J7>J3 straight, J7>J3 straight, J7>J3 hover");
  EXPECT_NEAR(plan_to(topology_named("warehouse"), "a13").start_heading_rad, 0.0, 1e-12);
}

TEST(Instructions, A53PassesFourTeesTurnsInTheCornerAndHoversOnTheThirdTee) {
  EXPECT_EQ(told("a53"),
            "J5>J9 straight, J5>J9 straight, J5>J9 straight, J5>J9 straight, J5>J5 left, "
            "J5>J9 straight, J5>J9 straight, J5>J9 hover");
  EXPECT_NEAR(plan_to(topology_named("warehouse"), "a53").start_heading_rad, 0.0, 1e-12);
}

TEST(Instructions, A03GoesStraightUpColumnZero) {
  EXPECT_EQ(told("a03"), "J4>J8 straight, J4>J8 straight, J4>J8 hover");
  EXPECT_NEAR(plan_to(topology_named("warehouse"), "a03").start_heading_rad, kPi / 2, 1e-12);
}

TEST(Instructions, ZoneAGoesAlongRowZeroFirstThenUp) {
  const servo::Topology topology = topology_named("warehouse");
  for (const auto& [label, node] : topology.labels) {
    if (node == topology.start) continue;
    const int i = label[1] - '0', j = label[2] - '0';
    const servo::Plan plan = plan_to(topology, label);
    ASSERT_EQ(plan.route.size(), static_cast<std::size_t>(i + j)) << label;
    for (int k = 0; k < i + j; ++k)
      EXPECT_NEAR(plan.route[static_cast<std::size_t>(k)].heading_rad, k < i ? 0.0 : kPi / 2, 1e-9) << label;
  }
}

}  // namespace
}  // namespace lineservo::apps
