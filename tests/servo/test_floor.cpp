#include "tests/servo/test_floor.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace lineservo::servo::testing {
namespace {

using features::Arms;
using features::JunctionCode;
using features::kPi;
using features::LevelPoint;
using features::LineFeature;
using features::radians;
using features::wrap_angle;

/// codes.md: an arm counts when 20 of the 400 pixels of it are in view along x and along y.
constexpr double kVisibleAlongX = 20.0 / 400.0 * 2.0 * TestFloor::kViewHalfWidth;
constexpr double kVisibleAlongY = 20.0 / 400.0 * 2.0 * TestFloor::kViewHalfHeight;

/// A closed range on one image axis.
struct Range {
  double low, high;
};

double overlap(const Range& a, const Range& b) {
  return std::min(a.high, b.high) - std::max(a.low, b.low);
}

/// The part of a segment inside |x| ≤ 1, |y| ≤ 0.75 (Liang and Barsky 1984), or none.
std::optional<std::pair<LevelPoint, LevelPoint>> clipped(const LevelPoint& a, const LevelPoint& b) {
  const Eigen::Vector2d p = a.vector(), d = b.vector() - p;
  double enter = 0.0, leave = 1.0;
  const Eigen::Vector2d half(TestFloor::kViewHalfWidth, TestFloor::kViewHalfHeight);
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (std::abs(p[axis]) > half[axis]) return std::nullopt;
      continue;
    }
    const double t0 = (-half[axis] - p[axis]) / d[axis], t1 = (half[axis] - p[axis]) / d[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter >= leave) return std::nullopt;
  const Eigen::Vector2d first = p + enter * d, last = p + leave * d;
  return std::pair{LevelPoint{first.x(), first.y()}, LevelPoint{last.x(), last.y()}};
}

/// Where an arm's rectangle lies in the image: beyond the node's square, up to the border.
bool is_visible(const LevelPoint& node, double half_stripe, double direction_rad) {
  const Range view_x{-TestFloor::kViewHalfWidth, TestFloor::kViewHalfWidth};
  const Range view_y{-TestFloor::kViewHalfHeight, TestFloor::kViewHalfHeight};
  Range x{node.x - half_stripe, node.x + half_stripe}, y{node.y - half_stripe, node.y + half_stripe};
  constexpr double kFar = 100.0;
  if (direction_rad == 0.0) y = {-kFar, y.low};
  if (direction_rad == kPi) y = {y.high, kFar};
  if (direction_rad == kPi / 2) x = {-kFar, x.low};
  if (direction_rad == -kPi / 2) x = {x.high, kFar};
  return overlap(x, view_x) >= kVisibleAlongX && overlap(y, view_y) >= kVisibleAlongY;
}

bool near(double angle_rad, double direction_rad) {
  return std::abs(wrap_angle(angle_rad - direction_rad)) < radians(25.0);
}

/// The arms of a node that codes.md counts as seen, and whether the line stops ahead in view.
features::CodeReading reading(const LevelPoint& node, double half_stripe, const std::vector<double>& angles) {
  const auto painted = [&](double direction_rad) {
    return std::any_of(angles.begin(), angles.end(), [&](double a) { return near(a, direction_rad); });
  };
  const auto seen = [&](double direction_rad) {
    return painted(direction_rad) && is_visible(node, half_stripe, direction_rad);
  };
  features::CodeReading code;
  const Arms arms{.forward = seen(0.0), .back = seen(kPi), .left = seen(kPi / 2), .right = seen(-kPi / 2)};
  code.raw = arms == Arms{} ? JunctionCode::straight : code_of(arms);  // no arm: the node is not in view
  code.line_ends_ahead = painted(kPi) && !painted(0.0) && is_visible(node, half_stripe, 0.0);
  code.held = code.smoothed = code.raw;
  return code;
}

}  // namespace

std::size_t TestFloor::add(std::string node, const Eigen::Vector2d& p_W) {
  nodes_.push_back({std::move(node), p_W, false});
  return nodes_.size() - 1;
}

std::size_t TestFloor::add_labelled(const std::string& label, const Eigen::Vector2d& p_W) {
  return labels_[label] = add(label, p_W);
}

void TestFloor::join(std::size_t a, std::size_t b) {
  edges_.push_back({a, b});
}

void TestFloor::erase(std::string_view a, std::string_view b) {
  const std::size_t i = index(a), j = index(b);
  std::erase_if(edges_, [&](const Edge& e) { return (e.a == i && e.b == j) || (e.a == j && e.b == i); });
}

std::size_t TestFloor::index(std::string_view node) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (nodes_[k].name == node) return k;
  }
  throw std::logic_error("the test floor has no node " + std::string(node));
}

std::vector<std::string> TestFloor::names() const {
  std::vector<std::string> names;
  for (const Node& node : nodes_) names.push_back(node.name);
  return names;
}

double TestFloor::heading(std::size_t from, std::size_t to) const {
  const Eigen::Vector2d way = nodes_[to].p_W - nodes_[from].p_W;
  return std::atan2(way.y(), way.x());
}

std::vector<std::size_t> TestFloor::neighbours(std::size_t node) const {
  std::vector<std::size_t> others;
  for (const Edge& e : edges_) {
    if (e.a == node) others.push_back(e.b);
    if (e.b == node) others.push_back(e.a);
  }
  return others;
}

Topology TestFloor::topology() const {
  Topology topology;
  topology.name = name_;
  topology.labels = labels_;
  for (const Node& node : nodes_) topology.nodes.push_back({node.name, {}, node.has_disc});
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const auto [a, b] = edges_[k];
    topology.edges.push_back({(nodes_[a].p_W - nodes_[b].p_W).norm()});
    topology.nodes[a].arms.push_back({k, b, heading(a, b), heading(a, b)});
    topology.nodes[b].arms.push_back({k, a, heading(b, a), heading(b, a)});
  }
  return topology;
}

std::vector<LineFeature> TestFloor::lines(const Pose& pose) const {
  std::vector<LineFeature> lines;
  for (const Edge& e : edges_) {
    const auto part = clipped(seen_point(pose, nodes_[e.a].p_W), seen_point(pose, nodes_[e.b].p_W));
    if (!part || (part->first.vector() - part->second.vector()).norm() < 0.2) continue;
    lines.push_back(line_through(part->first, part->second));
    lines.back().width = kStripe_m / pose.height_m;
  }
  std::stable_sort(lines.begin(), lines.end(), [](const LineFeature& a, const LineFeature& b) {
    return std::abs(a.theta_rad) < std::abs(b.theta_rad) - 1e-6;
  });
  return lines;
}

const TestFloor::Node* TestFloor::nearest_node(const Pose& pose) const {
  const Node* nearest = nullptr;
  double distance = 1.25;  // the corner of the view: √(1² + 0.75²)
  for (const Node& node : nodes_) {
    const double d = seen_point(pose, node.p_W).vector().norm();
    if (d >= distance) continue;
    distance = d;
    nearest = &node;
  }
  return nearest;
}

void TestFloor::add_junction(const Pose& pose, const Node& node, features::FrameFeatures& frame) const {
  const auto self = static_cast<std::size_t>(&node - nodes_.data());
  features::JunctionFeature junction;
  junction.centre = seen_point(pose, node.p_W);
  junction.quality = 1.0;
  std::vector<double> angles;
  for (const std::size_t other : neighbours(self)) {
    angles.push_back(wrap_angle(heading(self, other) - pose.heading_rad));
    junction.arms.push_back({angles.back(), 1.0});
  }
  frame.code = reading(junction.centre, 0.5 * kStripe_m / pose.height_m, angles);
  const bool straight_on = angles.size() == 2 && near(angles[0], wrap_angle(angles[1] + kPi));
  if (angles.size() >= 2 && !straight_on) frame.junction = junction;
  const bool is_disc_seen =
      std::abs(junction.centre.x) < kViewHalfWidth && std::abs(junction.centre.y) < kViewHalfHeight;
  if (!node.has_disc || !is_disc_seen) return;
  frame.start_marker = junction.centre;
  frame.code.raw = frame.code.held = frame.code.smoothed = JunctionCode::start;
}

features::FrameFeatures TestFloor::view(const Pose& pose) const {
  features::FrameFeatures frame;
  if (pose.height_m < 0.2) return frame;  // too near to the floor to see anything
  frame.lines = lines(pose);
  if (!frame.lines.empty()) frame.code.raw = frame.code.held = frame.code.smoothed = JunctionCode::straight;
  if (const Node* node = nearest_node(pose)) add_junction(pose, *node, frame);
  if (const LineFeature* line = frame.line()) {
    const double middle_x = 0.5 * (line->begin.x + line->end.x);
    frame.centroid_px = features::PixelPoint{200.0 * (1.0 + middle_x / kViewHalfWidth), 200.0};
  }
  return frame;
}

TestFloor warehouse_floor() {
  constexpr int kColumns = 6, kRows = 5;
  TestFloor floor("warehouse");
  const auto label = [](int i, int j) { return "a" + std::to_string(i) + std::to_string(j); };
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < kRows; ++j) floor.add_labelled(label(i, j), {0.6 + 3.6 * i, 0.6 + 6.8 / 3.0 * j});
  }
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < kRows; ++j) {
      if (i + 1 < kColumns) floor.join(label(i, j), label(i + 1, j));
      if (j + 1 < kRows) floor.join(label(i, j), label(i, j + 1));
    }
  }
  return floor;
}

namespace {

/// A regular polygon with key locations and stubs at its mid-sides, counter-clockwise from the bottom.
TestFloor ring_floor(const std::string& name, char zone, int sides) {
  constexpr double kApothem_m = 4.8, kStub_m = 0.6;
  TestFloor floor(name);
  const double step_rad = 2.0 * kPi / sides;
  const auto at = [](double radius_m, double angle_rad) {
    return Eigen::Vector2d(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
  };
  for (int k = 0; k < sides; ++k) {
    const double angle_rad = -kPi / 2 + k * step_rad;
    const std::size_t key =
        floor.add_labelled(zone + std::string("0") + std::to_string(k), at(kApothem_m, angle_rad));
    floor.add("corner" + std::to_string(k),
              at(kApothem_m / std::cos(step_rad / 2), angle_rad + step_rad / 2));
    floor.join(key, floor.add("stub" + std::to_string(k), at(kApothem_m - kStub_m, angle_rad)));
  }
  for (int k = 0; k < sides; ++k) {
    const std::string corner = "corner" + std::to_string(k);
    floor.join(zone + std::string("0") + std::to_string(k), corner);
    floor.join(corner, zone + std::string("0") + std::to_string((k + 1) % sides));
  }
  return floor;
}

}  // namespace

TestFloor square_floor() {
  return ring_floor("square", 'b', 4);
}

TestFloor octagon_floor() {
  return ring_floor("octagon", 'c', 8);
}

Pose on_node(const TestFloor& floor, std::string_view node, double heading_rad, double height_m) {
  return {floor.at(node), heading_rad, height_m};
}

}  // namespace lineservo::servo::testing
