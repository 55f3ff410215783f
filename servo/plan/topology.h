#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace lineservo::servo {

/// One painted arm of a node.
struct TopologyArm {
  std::size_t edge = 0;
  std::size_t to = 0;        ///< node at the other end
  double heading_rad = 0.0;  ///< in which the arm leaves the node, from +x of the floor, counter-clockwise
  double arrival_heading_rad = 0.0;  ///< of a traveller who reaches `to` along this arm
  double width_m = 0.0;              ///< of the line
};

/// A place where lines meet or end.
struct TopologyNode {
  std::string name;
  std::vector<TopologyArm> arms;
  bool has_disc = false;  ///< a red disc lies on it, which is all that a camera above it can tell
};

/// A way between two nodes.
struct TopologyEdge {
  double length_m = 0.0;
  double sharpest_corner_rad = 0.0;  ///< by which the line turns at once between its nodes, ≥ 0
  bool bends = false;                ///< it is not straight
};

/// What the executive may know of a floor: which nodes are joined, in which directions the arms leave, what
/// they are called. Lengths serve for time-outs and for choosing the shortest route only; there are no
/// coordinates.
struct Topology {
  std::string name;
  std::vector<TopologyNode> nodes;
  std::vector<TopologyEdge> edges;
  std::map<std::string, std::size_t> labels;  ///< DIF → node
  std::size_t start = 0;
  double view_m = 0.375;  ///< how far ahead the camera sees from its height: the default one from 0.5 m
};

}  // namespace lineservo::servo
