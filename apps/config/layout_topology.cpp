#include "apps/config/layout_topology.h"

#include "features/geometry/angles.h"

namespace lineservo::apps {

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
    topology.edge_lengths_m.push_back(length_m);
    topology.nodes[edge.from].arms.push_back(
        {index, edge.to, features::wrap_angle(leaving_rad), arriving_rad});
    topology.nodes[edge.to].arms.push_back({index, edge.from, back_rad, home_rad});
  }
  return topology;
}

}  // namespace lineservo::apps
