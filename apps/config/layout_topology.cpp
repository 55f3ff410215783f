#include "apps/config/layout_topology.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"
#include "features/mask/color_classes.h"

namespace lineservo::apps {
namespace {

bool is_bent(const vehicle::Curve& curve) {
  return curve.pieces().size() > 1 || curve.pieces().front().curvature_inv_m != 0.0;
}

constexpr double kOnNode_m = 1e-3;
constexpr double kSmallestDisc_m = 0.05;  // 350 pixels of the resized frame up to a height of 1 m

double sharpest_corner_rad(const vehicle::Curve& curve) {
  double sharpest_rad = 0.0;
  for (std::size_t k = 1; k < curve.pieces().size(); ++k) {
    const vehicle::CurvePiece& before = curve.pieces()[k - 1];
    const double end_rad = before.heading_rad + before.curvature_inv_m * before.length_m;
    sharpest_rad =
        std::max(sharpest_rad, std::abs(features::wrap_angle(curve.pieces()[k].heading_rad - end_rad)));
  }
  return sharpest_rad;
}

void add_edge(const vehicle::LayoutEdge& edge, servo::Topology& topology) {
  const std::size_t index = topology.edges.size();
  const double length_m = edge.centreline.length_m();
  const double leaving_rad = edge.centreline.at(0.0).heading_rad;
  const double arriving_rad = edge.centreline.at(length_m).heading_rad;
  const double back_rad = features::wrap_angle(arriving_rad + features::kPi);
  const double home_rad = features::wrap_angle(leaving_rad + features::kPi);
  topology.edges.push_back({length_m, sharpest_corner_rad(edge.centreline), is_bent(edge.centreline)});
  topology.nodes[edge.from].arms.push_back(
      {index, edge.to, features::wrap_angle(leaving_rad), arriving_rad, edge.width_m});
  topology.nodes[edge.to].arms.push_back({index, edge.from, back_rad, home_rad, edge.width_m});
}

}  // namespace

servo::Topology topology_of(const vehicle::Layout& layout) {
  servo::Topology topology;
  topology.name = layout.name;
  topology.labels = layout.labels;
  topology.start = layout.start;
  const std::vector<vehicle::LayoutMarker> discs = red_discs(layout);
  for (const vehicle::LayoutNode& node : layout.nodes) {
    const bool has_disc = std::any_of(discs.begin(), discs.end(), [&node](const auto& disc) {
      return disc.radius_m >= kSmallestDisc_m && (disc.p_W - node.p_W).norm() <= kOnNode_m;
    });
    topology.nodes.push_back({node.name, {}, has_disc});
  }
  for (const vehicle::LayoutEdge& edge : layout.edges) add_edge(edge, topology);
  return topology;
}

std::vector<vehicle::LayoutMarker> red_discs(const vehicle::Layout& layout) {
  const features::ColorClasses classes{features::SegmenterOptions{}};
  std::vector<vehicle::LayoutMarker> discs;
  for (const auto* markers : {&layout.start_markers, &layout.end_markers}) {
    for (const vehicle::LayoutMarker& marker : *markers) {
      const auto [b, g, r] = marker.colour;
      if ((classes.of(b, g, r) & features::kMarker) != 0) discs.push_back(marker);
    }
  }
  return discs;
}

}  // namespace lineservo::apps
