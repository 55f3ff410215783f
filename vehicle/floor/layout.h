#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "vehicle/floor/curve.h"
#include "vehicle/floor/floor_bitmap.h"

namespace lineservo::vehicle {

/// Paint, 8-bit blue, green, red.
using Bgr = std::array<std::uint8_t, 3>;

/// A place where lines meet or end.
struct LayoutNode {
  std::string name;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
};

/// A painted line between two nodes.
struct LayoutEdge {
  std::size_t from = 0;  ///< index of a node
  std::size_t to = 0;
  Curve centreline;  ///< runs from the node `from` to the node `to`
  double width_m = 0.36;
  Bgr colour = {0, 200, 230};
};

/// A painted disc.
struct LayoutMarker {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();
  double radius_m = 0.18;
  Bgr colour = {40, 40, 220};
};

/// A painted floor: the metric truth. The vehicle's side sees only pixels of it; apps derives the topological
/// graph.
struct Layout {
  std::string name;
  std::string description;
  std::vector<LayoutNode> nodes;
  std::vector<LayoutEdge> edges;
  std::vector<LayoutMarker> start_markers;
  std::vector<LayoutMarker> end_markers;
  std::size_t start = 0;                      ///< node of take-off
  std::map<std::string, std::size_t> labels;  ///< DIF → node
  Bgr floor_colour = {120, 120, 120};
  /// What is seen in the place of the edges, which then are the truth alone. Markers lie on it.
  std::shared_ptr<const FloorBitmap> bitmap = {};
};

/// Places and radii beyond these are refused: drawing in single precision is exact to 0.1 mm within them.
inline constexpr double kFarthest_m = 1e4;  ///< x and y, either way
inline constexpr double kLargestRadius_m = 1e3;

/// Every fault of the layout, one line each; empty when it is sound. Checks: at least one edge, indices in
/// range, distinct node names, widths of 5 mm to 2 m, centrelines that start and end on their nodes (1 mm),
/// are finite and keep to kFarthest_m and kLargestRadius_m; when all of that holds, that no lines run over
/// each other (overlaps.h).
std::vector<std::string> faults(const Layout& layout);

}  // namespace lineservo::vehicle
