#include "apps/track/track_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "features/geometry/angles.h"
#include "features/line/thinning.h"
#include "features/mask/packed_mask.h"

namespace lineservo::apps {
namespace {

using Points = std::vector<cv::Point2d>;

constexpr double kCorner_rad = features::radians(20.0);
constexpr double kSpurWidths = 1.0;  // shorter is a spur of the thinning

double length_of(const Points& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += cv::norm(points[i] - points[i - 1]);
  return sum;
}

/// The skeleton as pixels, cut into nodes and the chains between them.
class SkeletonCutter {
 public:
  explicit SkeletonCutter(const cv::Mat& mask) {
    features::PackedMask packed = features::PackedMask::from_mat(mask);
    features::Thinner().thin(packed);
    cv::copyMakeBorder(packed.to_mat(), skeleton_, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    owner_ = cv::Mat(skeleton_.size(), CV_32S, cv::Scalar(-1));
    used_ = cv::Mat::zeros(skeleton_.size(), CV_8U);
  }

  TrackGraph cut() {
    find_nodes();
    for (int y = 0; y < skeleton_.rows; ++y)
      for (int x = 0; x < skeleton_.cols; ++x)
        if (owner_.at<int>(y, x) >= 0) leave({x, y});
    find_rings();
    return std::move(graph_);
  }

 private:
  bool painted(const cv::Point& p) const { return skeleton_.at<std::uint8_t>(p) != 0; }
  int owner(const cv::Point& p) const { return owner_.at<int>(p); }

  std::vector<cv::Point> neighbours(const cv::Point& p) const {
    std::vector<cv::Point> list;
    for (const auto& [dx, dy] :
         {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
      if (const cv::Point q(p.x + dx, p.y + dy); painted(q)) list.push_back(q);
    return list;
  }

  /// Ends, and clusters of pixels where chains meet.
  void find_nodes() {
    cv::Mat meets = cv::Mat::zeros(skeleton_.size(), CV_8U);
    for (int y = 1; y + 1 < skeleton_.rows; ++y)
      for (int x = 1; x + 1 < skeleton_.cols; ++x)
        if (painted({x, y}) && crossings({x, y}) != 2) meets.at<std::uint8_t>(y, x) = 255;
    cv::Mat labels, statistics, centres;
    const int count = cv::connectedComponentsWithStats(meets, labels, statistics, centres, 8, CV_32S);
    for (int k = 1; k < count; ++k)
      graph_.nodes.emplace_back(centres.at<double>(k, 0) - 1.0, centres.at<double>(k, 1) - 1.0);
    owner_ = labels - 1;
  }

  /// How often the ring of neighbours changes from bare to painted: 1 at an end, 2 on a chain, more where
  /// chains meet.
  int crossings(const cv::Point& p) const {
    static const cv::Point kRing[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    int changes = 0;
    for (int k = 0; k < 8; ++k) changes += !painted(p + kRing[k]) && painted(p + kRing[(k + 1) % 8]) ? 1 : 0;
    return changes;
  }

  void leave(const cv::Point& from) {
    for (const cv::Point& next : neighbours(from)) {
      if (owner(next) >= 0) {
        if (owner(next) > owner(from)) add(owner(from), owner(next), {});
      } else if (used_.at<std::uint8_t>(next) == 0) {
        follow(owner(from), next);
      }
    }
  }

  void follow(int from, cv::Point at) {
    Points chain;
    while (true) {
      used_.at<std::uint8_t>(at) = 255;
      chain.emplace_back(at.x - 1.0, at.y - 1.0);
      std::optional<cv::Point> next;
      int reached = -1;
      for (const cv::Point& q : neighbours(at)) {
        const bool is_way_back = owner(q) == from && chain.size() < 3;
        if (owner(q) >= 0 && !is_way_back && reached < 0) reached = owner(q);
        if (owner(q) < 0 && used_.at<std::uint8_t>(q) == 0 && !next) next = q;
      }
      if (reached >= 0) return add(from, reached, std::move(chain));
      if (!next) return;
      at = *next;
    }
  }

  void add(int from, int to, Points chain) {
    Points points{graph_.nodes[static_cast<std::size_t>(from)]};
    points.insert(points.end(), chain.begin(), chain.end());
    points.push_back(graph_.nodes[static_cast<std::size_t>(to)]);
    graph_.edges.push_back({from, to, std::move(points), 0.0});
  }

  /// A closed line without a node gets one.
  void find_rings() {
    for (int y = 1; y + 1 < skeleton_.rows; ++y) {
      for (int x = 1; x + 1 < skeleton_.cols; ++x) {
        const cv::Point p(x, y);
        if (!painted(p) || owner(p) >= 0 || used_.at<std::uint8_t>(p) != 0) continue;
        owner_.at<int>(p) = static_cast<int>(graph_.nodes.size());
        graph_.nodes.emplace_back(x - 1.0, y - 1.0);
        leave(p);
      }
    }
  }

  cv::Mat skeleton_, owner_, used_;
  TrackGraph graph_;
};

/// Puts the graph right: no spurs, no double nodes, ends where the paint ends, corners cut.
class GraphMender {
 public:
  GraphMender(TrackGraph graph, const cv::Mat& mask) : graph_(std::move(graph)), mask_(mask) {
    cv::distanceTransform(mask, distance_, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    for (TrackEdge& edge : graph_.edges) edge.width_px = width_of(edge.points);
  }

  TrackGraph mend() {
    drop_spurs();
    merge_near_nodes();
    join_chains();
    for (std::size_t k = 0; k < graph_.edges.size(); ++k) smooth(graph_.edges[k]);
    carry_on_ends();
    place_meetings();
    for (std::size_t k = 0; k < graph_.edges.size(); ++k) cut_corners(k);
    compact();
    return std::move(graph_);
  }

 private:
  TrackEdge& edge(std::size_t k) { return graph_.edges[k]; }
  cv::Point2d& node(int n) { return graph_.nodes[static_cast<std::size_t>(n)]; }

  double half_width_at(const cv::Point2d& p) const {
    const int x = std::clamp(static_cast<int>(std::lround(p.x)), 0, mask_.cols - 1);
    const int y = std::clamp(static_cast<int>(std::lround(p.y)), 0, mask_.rows - 1);
    return distance_.at<float>(y, x);
  }

  /// The distance to the nearest bare pixel's middle is half a pixel more than half the width.
  double width_of(const Points& points) const {
    std::vector<double> widths;
    for (const cv::Point2d& p : points) widths.push_back(2.0 * half_width_at(p) - 1.0);
    std::nth_element(widths.begin(), widths.begin() + std::ssize(widths) / 2, widths.end());
    return std::max(1.0, widths[widths.size() / 2]);
  }

  int degree(int n) const {
    int count = 0;
    for (const TrackEdge& e : graph_.edges) count += (e.from == n ? 1 : 0) + (e.to == n ? 1 : 0);
    return count;
  }

  void drop_spurs() {
    std::vector<TrackEdge> kept;
    for (const TrackEdge& e : graph_.edges) {
      const bool hangs = (degree(e.from) == 1) != (degree(e.to) == 1);
      const int root = degree(e.from) == 1 ? e.to : e.from;
      const bool is_spur = hangs && length_of(e.points) < kSpurWidths * 2.0 * half_width_at(node(root));
      if (!is_spur) kept.push_back(e);
    }
    graph_.edges = std::move(kept);
  }

  /// A cross is thinned to two Ts a little apart.
  void merge_near_nodes() {
    for (bool again = true; std::exchange(again, false);) {
      for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
        const TrackEdge e = edge(k);
        if (e.from == e.to || degree(e.from) < 3 || degree(e.to) < 3) continue;
        if (length_of(e.points) > 1.2 * std::max(half_width_at(node(e.from)), half_width_at(node(e.to))))
          continue;
        node(e.from) = 0.5 * (node(e.from) + node(e.to));
        graph_.edges.erase(graph_.edges.begin() + static_cast<std::ptrdiff_t>(k));
        for (TrackEdge& other : graph_.edges) {
          if (other.from == e.to) other.from = e.from;
          if (other.to == e.to) other.to = e.from;
          if (other.from == e.from) other.points.front() = node(e.from);
          if (other.to == e.from) other.points.back() = node(e.from);
        }
        again = true;
        break;
      }
    }
  }

  /// What a spur cut in two is one line.
  void join_chains() {
    for (int n = 0; n < static_cast<int>(graph_.nodes.size()); ++n) {
      std::vector<std::size_t> at;
      for (std::size_t k = 0; k < graph_.edges.size(); ++k)
        if (edge(k).from == n || edge(k).to == n) at.push_back(k);
      if (at.size() != 2) continue;
      TrackEdge a = edge(at[0]), b = edge(at[1]);
      if (a.from == a.to || b.from == b.to) continue;
      if (a.to != n) reverse(a);
      if (b.from != n) reverse(b);
      a.points.insert(a.points.end(), b.points.begin() + 1, b.points.end());
      a.to = b.to;
      a.width_px = width_of(a.points);
      edge(at[0]) = a;
      graph_.edges.erase(graph_.edges.begin() + static_cast<std::ptrdiff_t>(at[1]));
    }
  }

  static void reverse(TrackEdge& e) {
    std::reverse(e.points.begin(), e.points.end());
    std::swap(e.from, e.to);
  }

  /// The staircase of the pixels goes: a moving mean over a width; the nodes stay.
  static void smooth(TrackEdge& e) {
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(std::max(3.0, 0.5 * e.width_px)));
    const Points raw = e.points;
    const std::ptrdiff_t last = std::ssize(raw) - 1;
    for (std::ptrdiff_t i = 1; i < last; ++i) {
      const std::ptrdiff_t r = std::min({reach, i, last - i});
      cv::Point2d sum;
      for (std::ptrdiff_t k = i - r; k <= i + r; ++k) sum += raw[static_cast<std::size_t>(k)];
      e.points[static_cast<std::size_t>(i)] = sum / static_cast<double>(2 * r + 1);
    }
  }

  /// The unit direction in which a line leaves its first point, from what lies one to three widths off.
  static cv::Point2d leaving(const Points& points, double width_px) {
    const auto at = [&points](double px) {
      return points[std::min(points.size() - 1, static_cast<std::size_t>(std::max(1.0, px)))];
    };
    const cv::Point2d d =
        at(3.0 * width_px) - at(static_cast<double>(points.size()) > 2.0 * width_px ? width_px : 0.0);
    const double norm = cv::norm(d);
    return norm > 0.0 ? d / norm : cv::Point2d();
  }

  /// Thinning takes half a width off an end.
  void carry_on_ends() {
    for (TrackEdge& e : graph_.edges) {
      for (int side = 0; side < 2; ++side) {
        if (degree(e.from) == 1) {
          const auto drop = std::min(e.points.size() - 2, static_cast<std::size_t>(0.75 * e.width_px));
          e.points.erase(e.points.begin(), e.points.begin() + static_cast<std::ptrdiff_t>(drop));
          const cv::Point2d out = -leaving(e.points, e.width_px);
          cv::Point2d end = e.points.front();
          while (is_painted(end + 0.25 * out) && cv::norm(out) > 0.0) end += 0.25 * out;
          e.points.front() = node(e.from) = end;
        }
        reverse(e);
      }
    }
  }

  bool is_painted(const cv::Point2d& p) const {
    const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
    return x >= 0 && y >= 0 && x < mask_.cols && y < mask_.rows && mask_.at<std::uint8_t>(y, x) != 0;
  }

  /// Where straight lines meet: the point nearest to all of them, Σ (I − d dᵀ) (p − q) = 0. The skeleton is
  /// drawn towards the broader side there.
  void place_meetings() {
    for (int n = 0; n < static_cast<int>(graph_.nodes.size()); ++n) {
      if (degree(n) < 3) continue;
      cv::Matx22d sum = cv::Matx22d::zeros();
      cv::Vec2d right(0, 0);
      double reach = 0.0;
      for (TrackEdge& e : graph_.edges) {
        for (int side = 0; side < 2; ++side, reverse(e)) {
          if (e.from != n) continue;
          const cv::Point2d d = leaving(e.points, e.width_px);
          const cv::Point2d q =
              e.points[std::min(e.points.size() - 1, static_cast<std::size_t>(2.0 * e.width_px) + 1)];
          const cv::Matx22d m(1 - d.x * d.x, -d.x * d.y, -d.x * d.y, 1 - d.y * d.y);
          sum += m;
          right += m * cv::Vec2d(q.x, q.y);
          reach = std::max(reach, e.width_px);
        }
      }
      if (std::abs(cv::determinant(sum)) < 0.05) continue;
      const cv::Vec2d p = sum.inv() * right;
      if (cv::norm(cv::Point2d(p[0], p[1]) - node(n)) > reach) continue;
      move(n, {p[0], p[1]}, reach);
    }
  }

  /// Lines lead straight to the node from where they are their own.
  void move(int n, const cv::Point2d& to, double reach) {
    node(n) = to;
    for (TrackEdge& e : graph_.edges) {
      for (int side = 0; side < 2; ++side, reverse(e)) {
        if (e.from != n) continue;
        const auto drop = std::min(e.points.size() - 2, static_cast<std::size_t>(1.2 * reach));
        e.points.erase(e.points.begin(), e.points.begin() + static_cast<std::ptrdiff_t>(drop));
        e.points.front() = to;
      }
    }
  }

  /// Cuts a line at its sharpest corner, if it has one; what is left comes later in the list.
  void cut_corners(std::size_t k) {
    const auto corner = sharpest_corner(edge(k));
    if (!corner) return;
    const auto [at, place] = *corner;
    const auto reach = static_cast<std::size_t>(std::max(3.0, edge(k).width_px));
    TrackEdge rest = edge(k);
    const int n = static_cast<int>(graph_.nodes.size());
    graph_.nodes.push_back(place);
    Points& head = edge(k).points;
    head.resize(at > reach ? at - reach : 1);
    head.push_back(place);
    edge(k).to = n;
    Points tail{place};
    for (std::size_t i = std::min(at + reach, rest.points.size() - 1); i < rest.points.size(); ++i)
      tail.push_back(rest.points[i]);
    rest.points = std::move(tail);
    rest.from = n;
    graph_.edges.push_back(rest);
    cut_corners(k);
  }

  /// By the directions of the line on both sides of a place, each over a width from half a width off.
  static std::optional<std::pair<std::size_t, cv::Point2d>> sharpest_corner(const TrackEdge& e) {
    const auto gap = static_cast<std::size_t>(std::max(3.0, 0.75 * e.width_px));
    const auto arm = gap + static_cast<std::size_t>(std::max(8.0, 1.5 * e.width_px));
    const Points& p = e.points;
    double sharpest_rad = kCorner_rad;
    std::optional<std::pair<std::size_t, cv::Point2d>> found;
    for (std::size_t i = arm; i + arm < p.size(); ++i) {
      const cv::Point2d in = p[i - gap] - p[i - arm], out = p[i + arm] - p[i + gap];
      const double cross = in.x * out.y - in.y * out.x;
      const double turn_rad = std::abs(std::atan2(cross, in.dot(out)));
      if (turn_rad <= sharpest_rad) continue;
      sharpest_rad = turn_rad;
      const cv::Point2d between = p[i + gap] - p[i - gap];
      const double s = (between.x * out.y - between.y * out.x) / cross;
      found = {i, p[i - gap] + s * in};
    }
    return found;
  }

  /// Nodes that no line leads to any more go.
  void compact() {
    std::map<int, int> kept;
    std::vector<cv::Point2d> nodes;
    for (TrackEdge& e : graph_.edges) {
      for (int* n : {&e.from, &e.to}) {
        const auto [it, is_new] = kept.try_emplace(*n, static_cast<int>(nodes.size()));
        if (is_new) nodes.push_back(node(*n));
        *n = it->second;
      }
    }
    graph_.nodes = std::move(nodes);
  }

  TrackGraph graph_;
  const cv::Mat& mask_;
  cv::Mat distance_;
};

}  // namespace

TrackGraph trace_track(const cv::Mat& mask) {
  return GraphMender(SkeletonCutter(mask).cut(), mask).mend();
}

}  // namespace lineservo::apps
