#include "apps/report/floor_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lineservo::apps {
namespace {

using nlohmann::ordered_json;

double millimetres(double length_m) {
  return std::round(length_m * 1e3) / 1e3;
}

ordered_json json_of(const Eigen::Vector2d& p_W) {
  return {millimetres(p_W.x()), millimetres(p_W.y())};
}

std::string css(const vehicle::Bgr& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[2], colour[1], colour[0]);
}

/// Of edges that follow on each other; a point that two share counts once.
ordered_json polyline(const std::vector<TravelledEdge>& edges) {
  ordered_json points = ordered_json::array();
  for (const TravelledEdge& edge : edges) {
    std::vector<Eigen::Vector2d> outline = edge.curve->outline();
    if (edge.reversed) std::reverse(outline.begin(), outline.end());
    if (!points.empty()) points.erase(points.size() - 1);
    for (const Eigen::Vector2d& p_W : outline) points.push_back(json_of(p_W));
  }
  return points;
}

ordered_json json_of(const vehicle::LayoutMarker& marker, std::string_view kind) {
  return {{"kind", kind},
          {"at", json_of(marker.p_W)},
          {"radius_m", marker.radius_m},
          {"colour", css(marker.colour)}};
}

}  // namespace

ordered_json floor_json(const vehicle::Layout& floor) {
  ordered_json json = {{"name", floor.name}, {"colour", css(floor.floor_colour)}};
  for (const char* list : {"nodes", "lines", "markers"}) json[list] = ordered_json::array();
  for (const vehicle::LayoutNode& node : floor.nodes)
    json["nodes"].push_back({{"name", node.name}, {"at", json_of(node.p_W)}});
  for (const vehicle::LayoutEdge& edge : floor.edges)
    json["lines"].push_back({{"width_m", edge.width_m},
                             {"colour", css(edge.colour)},
                             {"points", polyline({{&edge.centreline, false}})}});
  for (const vehicle::LayoutMarker& marker : floor.start_markers)
    json["markers"].push_back(json_of(marker, "start"));
  for (const vehicle::LayoutMarker& marker : floor.end_markers)
    json["markers"].push_back(json_of(marker, "end"));
  return json;
}

ordered_json route_json(const RouteTruth& route) {
  ordered_json legs = ordered_json::array();
  for (const LegTruth& leg : route.legs)
    legs.push_back({{"from", leg.from}, {"to", leg.to}, {"points", polyline(leg.edges)}});
  return legs;
}

}  // namespace lineservo::apps
