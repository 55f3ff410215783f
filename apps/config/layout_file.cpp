#include "apps/config/layout_file.h"

#include <algorithm>
#include <cmath>

#include "apps/config/input_error.h"
#include "apps/config/layout_bitmap.h"
#include "apps/config/yaml_reader.h"
#include "servo/plan/dif.h"

namespace lineservo::apps {
namespace {

using vehicle::Bgr;
using vehicle::Curve;
using vehicle::Layout;
using vehicle::LayoutEdge;
using vehicle::LayoutMarker;

// As in vehicle::faults(), which does not know the line of the file.
constexpr double kSmallestWidth_m = 0.005;
constexpr double kLargestWidth_m = 2.0;

struct LineStyle {
  double width_m = 0.36;
  Bgr colour = {0, 200, 230};
};

/// Builds a layout from one file; each part of the file has its own function.
class LayoutBuilder {
 public:
  explicit LayoutBuilder(const std::filesystem::path& file) : yaml_(file) {}

  Layout build() {
    const YAML::Node& root = yaml_.root();
    yaml_.allow(root,
                {"name", "description", "floor", "bitmap", "line", "nodes", "edges", "start", "end_markers",
                 "labels"},
                "a layout");
    layout_.name = yaml_.text(root, "name");
    layout_.description = yaml_.text(root, "description", "no description");
    read_floor(root["floor"]);
    layout_.bitmap = read_bitmap(yaml_);
    default_style_ = style(root["line"], LineStyle{}, {"width_m", "colour"}, "line");
    each(root, "nodes", [this](const YAML::Node& node) { read_node(node); });
    each(root, "edges", [this](const YAML::Node& edge) { read_edge(edge); });
    read_start(root);
    if (root["end_markers"]) {
      each(root, "end_markers", [this](const YAML::Node& marker) { read_end_marker(marker); });
    }
    read_labels(root["labels"]);
    check();
    return layout_;
  }

 private:
  template <typename Read>
  void each(const YAML::Node& root, const std::string& key, Read read) const {
    const YAML::Node list = root[key];
    if (!list || !list.IsSequence() || list.size() == 0)
      yaml_.fail(list ? list : root, "'" + key + "' must be a list with at least one item");
    for (const auto& item : list) read(item);
  }

  Bgr colour(const YAML::Node& map, const std::string& key, Bgr otherwise) const {
    if (!map[key]) return otherwise;
    const std::vector<double> rgb = yaml_.numbers(map, key, 3);
    for (const double level : rgb) {
      if (level < 0.0 || level > 255.0)
        yaml_.fail(map[key], "'" + key + "' is [red, green, blue], each 0 to 255");
    }
    const auto level = [&rgb](std::size_t i) { return static_cast<std::uint8_t>(rgb[i] + 0.5); };
    return {level(2), level(1), level(0)};
  }

  LineStyle style(const YAML::Node& map, LineStyle otherwise, const std::vector<std::string>& keys,
                  const std::string& what) const {
    if (!map) return otherwise;
    yaml_.allow(map, keys, what);
    const double width_m = yaml_.number(map, "width_m", otherwise.width_m);
    if (width_m < kSmallestWidth_m || width_m > kLargestWidth_m)
      yaml_.fail(map, "'width_m' of " + what + " must be 0.005 to 2");
    return {width_m, colour(map, "colour", otherwise.colour)};
  }

  std::size_t node_index(const YAML::Node& map, const std::string& key) const {
    const std::string name = yaml_.text(map, key);
    for (std::size_t i = 0; i < layout_.nodes.size(); ++i) {
      if (layout_.nodes[i].name == name) return i;
    }
    yaml_.fail(map[key], "'" + key + "' names no node: '" + name + "'");
  }

  void read_floor(const YAML::Node& floor) {
    if (!floor) return;
    yaml_.allow(floor, {"colour"}, "floor");
    layout_.floor_colour = colour(floor, "colour", layout_.floor_colour);
  }

  Eigen::Vector2d near_place(const Eigen::Vector2d& p_W, const YAML::Node& at) const {
    if (p_W.cwiseAbs().maxCoeff() > vehicle::kFarthest_m) yaml_.fail(at, "x and y must be -10000 to 10000 m");
    return p_W;
  }

  void read_node(const YAML::Node& node) {
    yaml_.allow(node, {"name", "x_m", "y_m"}, "a node");
    const std::string name = yaml_.text(node, "name");
    for (const vehicle::LayoutNode& other : layout_.nodes) {
      if (other.name == name) yaml_.fail(node, "node '" + name + "' stands twice");
    }
    layout_.nodes.push_back({name, near_place({yaml_.number(node, "x_m"), yaml_.number(node, "y_m")}, node)});
  }

  void read_edge(const YAML::Node& map) {
    const LineStyle paint =
        style(map, default_style_, {"from", "to", "arc", "through", "width_m", "colour"}, "an edge");
    LayoutEdge edge;
    edge.from = node_index(map, "from");
    edge.to = node_index(map, "to");
    edge.width_m = paint.width_m;
    edge.colour = paint.colour;
    try {
      edge.centreline = centreline(map, layout_.nodes[edge.from].p_W, layout_.nodes[edge.to].p_W);
    } catch (const std::invalid_argument& error) {
      yaml_.fail(map, "edge from '" + layout_.nodes[edge.from].name + "' to '" + layout_.nodes[edge.to].name +
                          "': " + error.what());
    }
    layout_.edges.push_back(std::move(edge));
  }

  Curve centreline(const YAML::Node& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    if (map["arc"] && map["through"]) yaml_.fail(map, "an edge is an arc or goes through points, not both");
    if (const YAML::Node arc = map["arc"]) {
      yaml_.allow(arc, {"centre", "direction"}, "an arc");
      const std::vector<double> c = yaml_.numbers(arc, "centre", 2);
      if (std::hypot(c[0] - from.x(), c[1] - from.y()) > vehicle::kLargestRadius_m)
        yaml_.fail(arc, "an arc's radius must be at most 1000 m");
      const std::string direction = yaml_.text(arc, "direction");
      if (direction != "left" && direction != "right")
        yaml_.fail(arc, "'direction' of an arc is left or right");
      return Curve::arc(from, to, {c[0], c[1]}, direction == "left");
    }
    std::vector<Eigen::Vector2d> points{from};
    if (const YAML::Node through = map["through"]) {
      if (!through.IsSequence()) yaml_.fail(through, "'through' must be a list of [x, y]");
      for (const auto& point : through) {
        const std::vector<double> p = yaml_.number_list(point, "a point of 'through'", 2);
        points.push_back(near_place({p[0], p[1]}, point));
      }
    }
    points.push_back(to);
    return Curve::polyline(points);
  }

  void read_start(const YAML::Node& root) {
    const YAML::Node start = root["start"];
    if (!start) yaml_.fail(root, "'start' is missing: {node: NAME}");
    yaml_.allow(start, {"node", "marker_radius_m", "marker_colour"}, "start");
    layout_.start = node_index(start, "node");
    const double radius_m = yaml_.number(start, "marker_radius_m", 0.0);
    if (radius_m != 0.0) add_marker(layout_.start_markers, layout_.start, radius_m, start, "marker_colour");
  }

  void read_end_marker(const YAML::Node& marker) {
    yaml_.allow(marker, {"node", "radius_m", "colour"}, "an end marker");
    add_marker(layout_.end_markers, node_index(marker, "node"), yaml_.number(marker, "radius_m"), marker,
               "colour");
  }

  void add_marker(std::vector<LayoutMarker>& markers, std::size_t node, double radius_m,
                  const YAML::Node& map, const std::string& colour_key) const {
    if (radius_m > 2.0 || radius_m <= 0.0)
      yaml_.fail(map, "a marker's radius must be above 0 and at most 2 m");
    LayoutMarker marker;
    marker.p_W = layout_.nodes[node].p_W;
    marker.radius_m = radius_m;
    marker.colour = colour(map, colour_key, marker.colour);
    markers.push_back(marker);
  }

  void read_labels(const YAML::Node& labels) {
    if (!labels) return;
    if (!labels.IsMap()) yaml_.fail(labels, "'labels' must map instructions to nodes: {a13: NAME}");
    for (const auto& pair : labels) {
      try {
        const std::string dif = servo::to_string(servo::parse_dif(pair.first.Scalar()));
        const std::size_t node = node_index(labels, pair.first.Scalar());
        if (!layout_.labels.emplace(dif, node).second)
          yaml_.fail(pair.first, "label " + dif + " stands twice");
      } catch (const std::invalid_argument& error) {
        yaml_.fail(pair.first, error.what());
      }
    }
  }

  void check() const {
    const std::vector<std::string> list = vehicle::faults(layout_);
    if (list.empty()) return;
    std::string all;
    for (const std::string& fault : list) all += (all.empty() ? "" : "; ") + fault;
    throw InputError(yaml_.file().string() + ": " + all);
  }

  YamlReader yaml_;
  Layout layout_;
  LineStyle default_style_;
};

}  // namespace

vehicle::Layout read_layout(const std::filesystem::path& file) {
  return LayoutBuilder(file).build();
}

}  // namespace lineservo::apps
