#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "features/frame_features.h"
#include "servo/plan/topology.h"
#include "tests/servo/test_pose.h"

namespace lineservo::servo::testing {

/// A floor of straight stripes between named nodes. It stands for two things: the topological graph that a
/// layout gives to the planner, and what ideal perception says of a frame, from geometry alone and without an
/// image.
class TestFloor {
 public:
  static constexpr double kStripe_m = 0.36;
  static constexpr double kViewHalfWidth = 1.0;    ///< of the default camera, normalised units
  static constexpr double kViewHalfHeight = 0.75;  ///< the same along y

  explicit TestFloor(std::string name) : name_(std::move(name)) {}

  std::size_t add(std::string node, const Eigen::Vector2d& p_W);
  std::size_t add_labelled(const std::string& label, const Eigen::Vector2d& p_W);
  /// Paints a red disc of the stripe's width over a node.
  void lay_disc(std::string_view node) { nodes_[index(node)].has_disc = true; }
  void join(std::size_t a, std::size_t b);
  void join(std::string_view a, std::string_view b) { join(index(a), index(b)); }
  /// Wears the paint between two nodes off.
  void erase(std::string_view a, std::string_view b);
  void move(std::string_view node, const Eigen::Vector2d& to_W) { nodes_[index(node)].p_W = to_W; }

  std::size_t index(std::string_view node) const;
  const Eigen::Vector2d& at(std::string_view node) const { return nodes_[index(node)].p_W; }
  std::vector<std::string> names() const;

  /// What a layout tells the planner. The first node is the start.
  Topology topology() const;

  /// Lines (most nearly vertical first), the nearest junction, and its code without any filter.
  features::FrameFeatures view(const Pose& pose) const;

 private:
  struct Node {
    std::string name;
    Eigen::Vector2d p_W;
    bool has_disc = false;
  };
  struct Edge {
    std::size_t a, b;
  };
  double heading(std::size_t from, std::size_t to) const;
  std::vector<std::size_t> neighbours(std::size_t node) const;
  std::vector<features::LineFeature> lines(const Pose& pose) const;
  const Node* nearest_node(const Pose& pose) const;
  void add_junction(const Pose& pose, const Node& node, features::FrameFeatures& frame) const;

  std::string name_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::map<std::string, std::size_t> labels_;
};

/// The grid of data/README.md, zone a: 6 columns at 3.6 m, 5 rows at 6.8/3 m, a node a00 … a54 on each
/// crossing.
TestFloor warehouse_floor();
/// data/README.md, zone b: a square of side 9.6 m, T stubs of 0.6 m to the inside at the mid-sides b00 … b03.
TestFloor square_floor();
/// data/README.md, zone c: an octagon of apothem 4.8 m with stubs at the mid-sides c00 … c07.
TestFloor octagon_floor();

/// The pose on a node, facing a heading, at height h.
Pose on_node(const TestFloor& floor, std::string_view node, double heading_rad, double height_m = 0.5);

}  // namespace lineservo::servo::testing
