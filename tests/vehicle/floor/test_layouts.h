#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "features/geometry/angles.h"
#include "vehicle/floor/layout.h"

// Layouts built in code, so that a test needs no file.
namespace lineservo::vehicle::test {

inline std::size_t add_node(Layout& layout, std::string name, const Eigen::Vector2d& p_W) {
  layout.nodes.push_back({std::move(name), p_W});
  return layout.nodes.size() - 1;
}

inline void add_line(Layout& layout, std::size_t from, std::size_t to, double width_m) {
  layout.edges.push_back({from, to, Curve::line(layout.nodes[from].p_W, layout.nodes[to].p_W), width_m});
}

/// A grid of columns × rows nodes, node (i, j) at index i rows + j, all neighbours joined; a red disc on (0,
/// 0).
inline Layout grid(int columns, int rows, const Eigen::Vector2d& spacing_m, double width_m) {
  Layout layout;
  layout.name = "grid";
  const Eigen::Vector2d origin_W(0.6, 0.6);
  const auto index = [rows](int i, int j) { return static_cast<std::size_t>(i * rows + j); };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      add_node(layout, "a" + std::to_string(i) + std::to_string(j),
               origin_W + Eigen::Vector2d(i * spacing_m.x(), j * spacing_m.y()));
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      if (i + 1 < columns) add_line(layout, index(i, j), index(i + 1, j), width_m);
      if (j + 1 < rows) add_line(layout, index(i, j), index(i, j + 1), width_m);
    }
  layout.start_markers.push_back({origin_W, 0.18});
  return layout;
}

/// Zone a: x = 0.6 + 3.6 i, i = 0…5; y = 0.6 + (6.8/3) j, j = 0…4.
inline Layout warehouse(double width_m = 0.36) {
  return grid(6, 5, {3.6, 6.8 / 3.0}, width_m);
}

/// One straight stripe between two points.
inline Layout single_line(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W, double width_m) {
  Layout layout;
  layout.name = "line";
  add_node(layout, "from", from_W);
  add_node(layout, "to", to_W);
  add_line(layout, 0, 1, width_m);
  return layout;
}

/// Stripes from the origin outwards at the given headings, 10 m long.
inline Layout star(const std::vector<double>& headings_rad, double width_m) {
  Layout layout;
  layout.name = "star";
  add_node(layout, "hub", {0.0, 0.0});
  for (const double heading_rad : headings_rad) {
    const Eigen::Vector2d tip_W(10.0 * std::cos(heading_rad), 10.0 * std::sin(heading_rad));
    add_line(layout, 0, add_node(layout, "tip" + std::to_string(layout.nodes.size()), tip_W), width_m);
  }
  return layout;
}

/// Zone d: a whole circle about the origin from (0, −radius), with the red disc on its start.
inline Layout circle(double radius_m = 5.3, double width_m = 0.36) {
  Layout layout;
  layout.name = "circle";
  const Eigen::Vector2d start_W(0.0, -radius_m);
  add_node(layout, "d00", start_W);
  layout.edges.push_back({0, 0, Curve::arc(start_W, start_W, {0.0, 0.0}, true), width_m});
  layout.start_markers.push_back({start_W, 0.18});
  return layout;
}

/// 1 m straight along x, an arc to the left of 1.5 m over 45°, 1 m straight, joined at nodes.
inline Layout bend(double width_m = 0.1, double radius_m = 1.5) {
  const double turn_rad = features::radians(45.0);
  const Eigen::Vector2d a(0.0, 0.0), b(1.0, 0.0), centre(1.0, radius_m);
  const Eigen::Vector2d c = centre + radius_m * Eigen::Vector2d(std::sin(turn_rad), -std::cos(turn_rad));
  const Eigen::Vector2d d = c + Eigen::Vector2d(std::cos(turn_rad), std::sin(turn_rad));
  Layout layout;
  layout.name = "bend";
  for (const auto& [name, p_W] : {std::pair{"a", a}, std::pair{"b", b}, std::pair{"c", c}, std::pair{"d", d}})
    add_node(layout, name, p_W);
  add_line(layout, 0, 1, width_m);
  layout.edges.push_back({1, 2, Curve::arc(b, c, centre, true), width_m});
  add_line(layout, 2, 3, width_m);
  return layout;
}

}  // namespace lineservo::vehicle::test
