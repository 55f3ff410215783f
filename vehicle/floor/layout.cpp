#include "vehicle/floor/layout.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "vehicle/floor/overlaps.h"

namespace lineservo::vehicle {
namespace {

constexpr double kNodeTolerance_m = 1e-3;
constexpr double kSmallestWidth_m = 0.005;
constexpr double kLargestWidth_m = 2.0;

using Faults = std::vector<std::string>;

// NaN is not.
bool is_near(const Eigen::Vector2d& p_W) {
  return std::abs(p_W.x()) <= kFarthest_m && std::abs(p_W.y()) <= kFarthest_m;
}

bool is_drawable(const Curve& curve) {
  return std::all_of(curve.pieces().begin(), curve.pieces().end(), [](const CurvePiece& piece) {
    return is_near(piece.start_W) &&
           (piece.curvature_inv_m == 0.0 || std::abs(piece.curvature_inv_m) >= 1.0 / kLargestRadius_m);
  });
}

bool is_finite(const Curve& curve) {
  const CurvePoint end = curve.at(curve.length_m());
  return std::isfinite(curve.length_m()) && curve.at(0.0).p_W.allFinite() && end.p_W.allFinite();
}

void check_nodes(const Layout& layout, Faults& list) {
  std::set<std::string> names;
  for (const LayoutNode& node : layout.nodes) {
    if (!names.insert(node.name).second) list.push_back("node " + node.name + ": the name is used twice");
    if (!is_near(node.p_W)) list.push_back("node " + node.name + ": x and y must be within 10000 m");
  }
  if (layout.start >= layout.nodes.size()) list.push_back("start: no such node");
  for (const auto& [label, node] : layout.labels)
    if (node >= layout.nodes.size()) list.push_back("label " + label + ": no such node");
}

void check_centreline(const Layout& layout, const LayoutEdge& edge, const std::string& name, Faults& list) {
  const Curve& curve = edge.centreline;
  if (curve.pieces().empty()) return list.push_back(name + ": the centreline is empty");
  if (!is_finite(curve)) return list.push_back(name + ": the centreline must be finite");
  if (!is_drawable(curve))
    list.push_back(name +
                   ": the centreline must stay within 10000 m, and its arcs have a radius of up to 1000 m");
  const auto apart_m = [&](double s_m, std::size_t node) {
    return (curve.at(s_m).p_W - layout.nodes[node].p_W).norm();
  };
  if (!(apart_m(0.0, edge.from) <= kNodeTolerance_m))
    list.push_back(name + ": the centreline does not start on node " + layout.nodes[edge.from].name);
  if (!(apart_m(curve.length_m(), edge.to) <= kNodeTolerance_m))
    list.push_back(name + ": the centreline does not end on node " + layout.nodes[edge.to].name);
}

void check_edge(const Layout& layout, std::size_t index, Faults& list) {
  const LayoutEdge& edge = layout.edges[index];
  const std::string name = "edge " + std::to_string(index);
  if (!(edge.width_m >= kSmallestWidth_m && edge.width_m <= kLargestWidth_m))
    list.push_back(name + ": the width must be 0.005 to 2 m");
  if (edge.from >= layout.nodes.size() || edge.to >= layout.nodes.size())
    return list.push_back(name + ": no such node");
  check_centreline(layout, edge, name, list);
}

void check_markers(const std::vector<LayoutMarker>& markers, const std::string& kind, Faults& list) {
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const std::string name = kind + " marker " + std::to_string(i);
    if (!is_near(markers[i].p_W)) list.push_back(name + ": x and y must be within 10000 m");
    if (!(markers[i].radius_m >= 0.5 * kSmallestWidth_m && markers[i].radius_m <= kLargestWidth_m))
      list.push_back(name + ": the radius must be 0.0025 to 2 m");
  }
}

}  // namespace

std::vector<std::string> faults(const Layout& layout) {
  Faults list;
  if (layout.edges.empty()) list.push_back("a layout needs at least one edge");
  check_nodes(layout, list);
  for (std::size_t i = 0; i < layout.edges.size(); ++i) check_edge(layout, i, list);
  check_markers(layout.start_markers, "start", list);
  check_markers(layout.end_markers, "end", list);
  return list.empty() ? overlaps(layout) : list;
}

}  // namespace lineservo::vehicle
