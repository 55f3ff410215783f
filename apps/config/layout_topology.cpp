#include "apps/config/layout_topology.h"

#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

bool is_bent(const vehicle::Curve& curve) {
  return curve.pieces().size() > 1 || curve.pieces().front().curvature_inv_m != 0.0;
}

}  // namespace

servo::Topology topology_of(const vehicle::Layout& layout) {
  servo::Topology topology;
  topology.name = layout.name;
  topology.labels = layout.labels;
  topology.start = layout.start;
  for (const vehicle::LayoutNode& node : layout.nodes) topology.nodes.push_back({node.name, {}});
  for (const vehicle::LayoutEdge& edge : layout.edges) {
    const std::size_t index = topology.edge_lengths_m.size();
    const double length_m = edge.centreline.length_m();
    const double leaving_rad = edge.centreline.at(0.0).heading_rad;
    const double arriving_rad = edge.centreline.at(length_m).heading_rad;
    const double back_rad = features::wrap_angle(arriving_rad + features::kPi);
    const double home_rad = features::wrap_angle(leaving_rad + features::kPi);
    const bool bends = is_bent(edge.centreline);
    topology.edge_lengths_m.push_back(length_m);
    topology.nodes[edge.from].arms.push_back(
        {index, edge.to, features::wrap_angle(leaving_rad), arriving_rad, bends});
    topology.nodes[edge.to].arms.push_back({index, edge.from, back_rad, home_rad, bends});
  }
  return topology;
}

}  // namespace lineservo::apps
