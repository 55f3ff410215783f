#pragma once

#include <string>

#include "apps/config/data_folder.h"
#include "apps/config/layout_file.h"
#include "apps/config/layout_topology.h"
#include "servo/plan/plan.h"

namespace lineservo::apps::testing {

inline vehicle::Layout shipped_layout(const std::string& name) {
  return read_layout(find_data(DataKind::layout, name));
}

inline servo::Plan plan_on(const vehicle::Layout& layout, const std::string& target) {
  const servo::Topology topology = topology_of(layout);
  return servo::compile(topology, servo::find_target(topology, target), target);
}

/// A straight edge between two nodes of a layout.
inline vehicle::LayoutEdge straight_edge(const vehicle::Layout& layout, std::size_t from, std::size_t to,
                                         double width_m) {
  vehicle::LayoutEdge edge;
  edge.from = from;
  edge.to = to;
  edge.centreline = vehicle::Curve::line(layout.nodes[from].p_W, layout.nodes[to].p_W);
  edge.width_m = width_m;
  return edge;
}

}  // namespace lineservo::apps::testing
