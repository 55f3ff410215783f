#include "apps/scoring/route_truth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

using features::kPi;
using features::wrap_angle;
using vehicle::CurvePoint;
using vehicle::CurveProjection;

LegOffset offset_from(const TravelledEdge& edge, const Eigen::Vector2d& p_W) {
  const CurveProjection projection = edge.curve->project(p_W);
  return {projection.distance_m, edge.reversed ? -projection.signed_offset_m : projection.signed_offset_m};
}

/// Against the straight line that leads into the first edge; nothing when the place lies beyond the
/// beginning.
bool behind_start(const LegTruth& leg, const Eigen::Vector2d& p_W, LegOffset& offset) {
  const CurvePoint start = travelled_point(leg.edges.front(), 0.0);
  const Eigen::Vector2d forward(std::cos(start.heading_rad), std::sin(start.heading_rad));
  const Eigen::Vector2d from_start = p_W - start.p_W;
  if (from_start.dot(forward) >= 0.0) return false;
  const double left_m = forward.x() * from_start.y() - forward.y() * from_start.x();
  offset = {std::abs(left_m), left_m};
  return true;
}

std::string axis_of(const LegTruth& leg) {
  for (const auto& edge : leg.edges) {
    for (const auto& piece : edge.curve->pieces()) {
      if (piece.curvature_inv_m != 0.0) return "";
    }
  }
  const auto along = [&leg](double heading_rad) {
    return std::abs(std::sin(leg.start_heading_rad - heading_rad)) < 1e-6;
  };
  return along(0.0) ? "x" : along(kPi / 2) ? "y" : "";
}

void finish(LegTruth& leg, const std::string& to) {
  leg.to = to;
  leg.start_heading_rad = travelled_point(leg.edges.front(), 0.0).heading_rad;
  leg.end_heading_rad = travelled_point(leg.edges.back(), leg.edges.back().curve->length_m()).heading_rad;
  leg.axis = axis_of(leg);
}

std::size_t node_named(const vehicle::Layout& layout, const std::string& name) {
  const auto it = std::find_if(layout.nodes.begin(), layout.nodes.end(),
                               [&name](const auto& n) { return n.name == name; });
  return static_cast<std::size_t>(it - layout.nodes.begin());
}

}  // namespace

CurvePoint travelled_point(const TravelledEdge& edge, double arc_length_m) {
  if (!edge.reversed) return edge.curve->at(arc_length_m);
  CurvePoint point = edge.curve->at(edge.curve->length_m() - arc_length_m);
  point.heading_rad = wrap_angle(point.heading_rad + kPi);
  return point;
}

LegOffset offset_from(const LegTruth& leg, const Eigen::Vector2d& p_W) {
  LegOffset before;
  const LegOffset after = offset_after_node(leg, p_W);
  return behind_start(leg, p_W, before) && before.distance_m < after.distance_m ? before : after;
}

LegOffset offset_after_node(const LegTruth& leg, const Eigen::Vector2d& p_W) {
  LegOffset best;
  best.distance_m = std::numeric_limits<double>::infinity();
  for (const TravelledEdge& edge : leg.edges) {
    const LegOffset offset = offset_from(edge, p_W);
    if (offset.distance_m < best.distance_m) best = offset;
  }
  return best;
}

RouteTruth route_truth(const vehicle::Layout& layout, const servo::Plan& plan) {
  RouteTruth truth;
  truth.target = plan.route.back().to;
  for (const servo::PlanStep& step : plan.steps) truth.nodes.push_back(node_named(layout, step.node));

  LegTruth leg;
  leg.from = layout.nodes[layout.start].name;
  std::size_t at = layout.start, step = 0;
  for (const servo::TopologyArm& arm : plan.route) {
    const vehicle::LayoutEdge& edge = layout.edges[arm.edge];
    leg.edges.push_back({&edge.centreline, edge.from != at});
    at = arm.to;
    if (step >= plan.steps.size() || truth.nodes[step] != at) continue;
    if (plan.steps[step].manoeuvre != servo::Manoeuvre::go_straight) {
      finish(leg, layout.nodes[at].name);
      truth.closing_steps.push_back(static_cast<int>(step));
      truth.closed_by_stop.push_back(plan.steps[step].manoeuvre == servo::Manoeuvre::hover);
      truth.legs.push_back(std::exchange(leg, {}));
      leg.from = layout.nodes[at].name;
    }
    ++step;
  }
  return truth;
}

}  // namespace lineservo::apps
