#include "vehicle/floor/floor_truth.h"

#include <algorithm>
#include <limits>

namespace lineservo::vehicle {
namespace {

constexpr double kFar_m = std::numeric_limits<double>::infinity();

double distance_to_markers_m(const std::vector<LayoutMarker>& markers, const Eigen::Vector2d& p_W) {
  double nearest_m = kFar_m;
  for (const LayoutMarker& marker : markers)
    nearest_m = std::min(nearest_m, (p_W - marker.p_W).norm() - marker.radius_m);
  return nearest_m;
}

}  // namespace

NearestEdge nearest_edge(const Layout& layout, const Eigen::Vector2d& p_W) {
  NearestEdge best;
  best.projection.distance_m = kFar_m;
  for (std::size_t i = 0; i < layout.edges.size(); ++i) {
    const CurveProjection projection = layout.edges[i].centreline.project(p_W);
    if (projection.distance_m < best.projection.distance_m) best = {i, projection};
  }
  return best;
}

double distance_to_centreline_m(const Layout& layout, const Eigen::Vector2d& p_W) {
  return nearest_edge(layout, p_W).projection.distance_m;
}

double distance_to_paint_m(const Layout& layout, const Eigen::Vector2d& p_W) {
  double nearest_m = std::min(distance_to_markers_m(layout.start_markers, p_W),
                              distance_to_markers_m(layout.end_markers, p_W));
  for (const LayoutEdge& edge : layout.edges)
    nearest_m = std::min(nearest_m, edge.centreline.project(p_W).distance_m - 0.5 * edge.width_m);
  return std::max(0.0, nearest_m);
}

}  // namespace lineservo::vehicle
