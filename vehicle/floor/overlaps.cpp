#include "vehicle/floor/overlaps.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <set>

#include "features/geometry/angles.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;

constexpr double kLeastAngle_rad = features::radians(25.0);
constexpr double kEnd_m = 1e-3;

/// One straight or round piece of an edge between two joints: nodes, or corners inside a polyline.
struct Strip {
  std::size_t edge = 0;
  std::size_t from = 0, to = 0;
  Curve curve;
  double width_m = 0.0;
  Eigen::AlignedBox2d box;
};

// A curve is nowhere further from its middle than half its length.
Eigen::AlignedBox2d box_of(const Curve& curve) {
  const double length_m = curve.length_m();
  if (curve.at(0.0).curvature_inv_m == 0.0)
    return Eigen::AlignedBox2d(curve.at(0.0).p_W).extend(curve.at(length_m).p_W);
  const Vector2d middle_W = curve.at(0.5 * length_m).p_W, half = Vector2d::Constant(0.5 * length_m);
  return {middle_W - half, middle_W + half};
}

/// All strips of a layout and how they hang together.
class Strips {
 public:
  explicit Strips(const Layout& layout) : at_joint_(layout.nodes.size()) {
    for (std::size_t i = 0; i < layout.edges.size(); ++i) add(i, layout.edges[i]);
  }
  const std::vector<Strip>& all() const { return strips_; }

  /// Whether the painted way from one joint to another is no longer than so much (Dijkstra).
  bool within(std::size_t from, std::size_t to, double limit_m) const {
    std::map<std::size_t, double> best_m{{from, 0.0}};
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(0.0, from);
    while (!open.empty()) {
      const auto [way_m, joint] = open.top();
      open.pop();
      if (joint == to) return true;
      for (const std::size_t index : at_joint_[joint]) {
        const Strip& strip = strips_[index];
        const std::size_t other = strip.from == joint ? strip.to : strip.from;
        const double there_m = way_m + strip.curve.length_m();
        const auto [it, is_new] = best_m.try_emplace(other, there_m);
        if (there_m > limit_m || (!is_new && it->second <= there_m)) continue;
        it->second = there_m;
        open.emplace(there_m, other);
      }
    }
    return false;
  }

 private:
  void add(std::size_t index, const LayoutEdge& edge) {
    const std::vector<Curve> parts = edge.centreline.parts();
    std::size_t from = edge.from;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool is_last = k + 1 == parts.size();
      const std::size_t to = is_last ? edge.to : at_joint_.size();
      if (!is_last) at_joint_.emplace_back();
      at_joint_[from].push_back(strips_.size());
      at_joint_[to].push_back(strips_.size());
      strips_.push_back({index, from, to, parts[k], edge.width_m, box_of(parts[k])});
      from = to;
    }
  }

  std::vector<Strip> strips_;
  std::vector<std::vector<std::size_t>> at_joint_;  ///< strips that end there; the nodes come first
};

/// Looks for a place of one strip that lies on the paint of another, not near a joint of both.
class TouchSearch {
 public:
  TouchSearch(const Strips& strips, const Strip& a, const Strip& b)
      : strips_(strips),
        a_(a),
        b_(b),
        reach_m_(0.5 * (a.width_m + b.width_m)),
        step_m_(reach_m_ / 8.0),
        joint_m_(reach_m_ / std::sin(kLeastAngle_rad) + 2.0 * step_m_) {}

  std::optional<Vector2d> place() const {
    const Vector2d margin = Vector2d::Constant(reach_m_);
    if (!Eigen::AlignedBox2d(a_.box.min() - margin, a_.box.max() + margin).intersects(b_.box))
      return std::nullopt;
    return place_between(0.0, a_.curve.length_m());
  }

 private:
  // By bisection: a stretch is nowhere further from its middle than half its length.
  std::optional<Vector2d> place_between(double begin_m, double end_m) const {
    const double middle_m = 0.5 * (begin_m + end_m), half_m = 0.5 * (end_m - begin_m);
    const Vector2d p_W = a_.curve.at(middle_m).p_W;
    const CurveProjection on_b = b_.curve.project(p_W);
    if (on_b.distance_m - half_m >= reach_m_) return std::nullopt;
    if (half_m > step_m_) {
      const std::optional<Vector2d> first = place_between(begin_m, middle_m);
      return first ? first : place_between(middle_m, end_m);
    }
    // Paint ends square: a point beyond an end is beside the paint.
    const bool is_beside = on_b.arc_length_m > kEnd_m && on_b.arc_length_m < b_.curve.length_m() - kEnd_m;
    const bool touches = is_beside && on_b.distance_m < reach_m_ && !near_joint(middle_m);
    return touches ? std::optional(p_W) : std::nullopt;
  }

  bool near_joint(double s_m) const {
    const auto leads_to_b = [this](std::size_t joint, double way_m) {
      const double left_m = joint_m_ - way_m;
      return left_m >= 0.0 &&
             (strips_.within(joint, b_.from, left_m) || strips_.within(joint, b_.to, left_m));
    };
    return leads_to_b(a_.from, s_m) || leads_to_b(a_.to, a_.curve.length_m() - s_m);
  }

  const Strips& strips_;
  const Strip &a_, &b_;
  double reach_m_, step_m_, joint_m_;
};

std::string name_of(const Layout& layout, std::size_t edge) {
  const LayoutEdge& e = layout.edges[edge];
  return fmt::format("edge {} ({} to {})", edge, layout.nodes[e.from].name, layout.nodes[e.to].name);
}

/// Two lines between the same nodes whose paint is one all along, however short they are.
bool are_doubled(const LayoutEdge& a, const LayoutEdge& b) {
  if (std::minmax(a.from, a.to) != std::minmax(b.from, b.to)) return false;
  constexpr int kPlaces = 16;
  for (int k = 0; k <= kPlaces; ++k) {
    const Vector2d p_W = a.centreline.at(k * a.centreline.length_m() / kPlaces).p_W;
    if (b.centreline.project(p_W).distance_m >= 0.5 * (a.width_m + b.width_m)) return false;
  }
  return true;
}

std::string told(const Layout& layout, std::size_t a, std::size_t b, const Vector2d& p_W) {
  const std::string place = fmt::format("at ({:.2f}, {:.2f}) m", p_W.x(), p_W.y());
  if (a == b)
    return fmt::format("{} runs over itself {}: put a node where lines cross", name_of(layout, a), place);
  return fmt::format("{} and {} run over each other {}: lines may meet at nodes only, at 25° or more",
                     name_of(layout, a), name_of(layout, b), place);
}

}  // namespace

std::vector<std::string> overlaps(const Layout& layout) {
  std::vector<std::string> list;
  std::set<std::pair<std::size_t, std::size_t>> told_of;
  for (std::size_t i = 0; i < layout.edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!are_doubled(layout.edges[i], layout.edges[j])) continue;
      list.push_back(fmt::format("{} doubles {}: paint a line once", name_of(layout, i), name_of(layout, j)));
      told_of.emplace(j, i);
    }
  }
  const Strips strips(layout);
  for (const Strip& a : strips.all()) {
    for (const Strip& b : strips.all()) {
      const auto pair = std::minmax(a.edge, b.edge);
      if (&a == &b || told_of.contains(pair)) continue;
      const std::optional<Vector2d> place = TouchSearch(strips, a, b).place();
      if (!place) continue;
      list.push_back(told(layout, pair.first, pair.second, *place));
      told_of.insert(pair);
    }
  }
  return list;
}

}  // namespace lineservo::vehicle
