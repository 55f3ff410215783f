#include "servo/plan/whereabouts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

constexpr double kSameArm_rad = features::radians(30.0);
constexpr int kMayMiss = 2;            // nodes in a row
constexpr double kShortest_m = 0.1;    // of any edge
constexpr double kForgotten = 1e-9;    // of the weight
constexpr double kTurnedAside = 1e-2;  // made a turn where no node is

/// How a node is told, or none when the codes have no name for it.
std::optional<NodeSignature> told_as(const Topology& floor, const TopologyArm& by) {
  try {
    return signature_at(floor, by);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

bool is_plain(const NodeSignature& s) {
  return s.code == features::JunctionCode::straight && !s.line_ends && s.bend == Bend::none;
}

bool told_alike(const NodeSignature& a, const NodeSignature& b) {
  return a.code == b.code && a.line_ends == b.line_ends && a.bend == b.bend;
}

}  // namespace

Whereabouts::Whereabouts(std::shared_ptr<const Topology> floor, const Arm& start,
                         const WhereaboutsOptions& options)
    : floor_(std::move(floor)), options_(options) {
  if (!floor_) return;
  const double share = options.elsewhere / static_cast<double>(2 * floor_->edges.size());
  for (std::size_t node = 0; node < floor_->nodes.size(); ++node) {
    for (std::size_t k = 0; k < floor_->nodes[node].arms.size(); ++k) {
      const Arm one{node, k};
      const bool is_start = one == start;
      const double anywhere_m = is_start ? 0.0 : floor_->edges[arm(one).edge].length_m;
      hypotheses_.push_back({one, false, is_start ? 1.0 - options.elsewhere : share, {0.0, anywhere_m}});
    }
  }
}

// p(node | seen) ∝ p(seen | node) Σ p(came here): the node at the end of the edge flown, one further on when
// nodes on the way were missed, or none at all.
void Whereabouts::tell(const NodeSignature& seen, const Way& way) {
  std::vector<Hypothesis> reached;
  for (Hypothesis h : std::exchange(hypotheses_, {})) {
    if (h.on_node) continue;
    h.along.at_least_m += way.at_least_m;
    h.along.at_most_m += way.at_most_m;
    reach(h, seen, h.weight, kMayMiss, reached);
    h.weight *= options_.ghost;
    reached.push_back(h);
  }
  hypotheses_ = std::move(reached);
  normalise();
}

void Whereabouts::reach(const Hypothesis& h, const NodeSignature& seen, double weight, int may_miss,
                        std::vector<Hypothesis>& reached) const {
  const TopologyArm& by = arm(h.arm);
  const double length_m = floor_->edges[by.edge].length_m;
  const double shortest_m = length_m * (1.0 - options_.length_tolerance) - options_.length_slack_m;
  const double longest_m = length_m * (1.0 + options_.length_tolerance) + options_.length_slack_m;
  const bool fits = h.along.at_most_m >= shortest_m && h.along.at_least_m <= longest_m;
  reached.push_back({h.arm, true, weight * likelihood(by, seen) * (fits ? 1.0 : options_.misfit), {}});
  const std::optional<Arm> next = onward(by, 0.0);
  const double beyond_m = h.along.at_most_m - std::max(kShortest_m, shortest_m);
  if (!next || beyond_m < 0.0) return;
  const auto told = told_as(*floor_, by);
  const bool unseen = told && is_plain(*told);  // such a node is never told
  if (!unseen && may_miss == 0) return;
  const Hypothesis further{*next, false, 0.0, {std::max(0.0, h.along.at_least_m - longest_m), beyond_m}};
  reach(further, seen, weight * (unseen ? 1.0 : options_.missed), may_miss - (unseen ? 0 : 1), reached);
}

double Whereabouts::likelihood(const TopologyArm& by, const NodeSignature& seen) const {
  const auto told = told_as(*floor_, by);
  if (told && is_plain(*told)) return options_.ghost;
  return told && told_alike(*told, seen) ? options_.told_right : options_.told_wrong;
}

std::optional<Whereabouts::Arm> Whereabouts::onward(const TopologyArm& by, double turn_rad) const {
  std::optional<Arm> best;
  double nearest_rad = kSameArm_rad;
  const auto& arms = floor_->nodes[by.to].arms;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const double off_rad =
        std::abs(features::wrap_angle(arms[k].heading_rad - by.arrival_heading_rad - turn_rad));
    if (off_rad >= nearest_rad) continue;
    nearest_rad = off_rad;
    best = Arm{by.to, k};
  }
  return best;
}

void Whereabouts::leave(double turn_rad) {
  std::vector<Hypothesis> left;
  for (Hypothesis h : std::exchange(hypotheses_, {})) {
    if (!h.on_node) {
      if (std::abs(turn_rad) > kSameArm_rad) h.weight *= kTurnedAside;
      left.push_back(h);
    } else {
      go_on(h, turn_rad, left);
    }
  }
  hypotheses_ = std::move(left);
  normalise();
}

void Whereabouts::go_on(const Hypothesis& h, double turn_rad, std::vector<Hypothesis>& left) const {
  const TopologyArm& by = arm(h.arm);
  const auto meant = onward(by, turn_rad);
  if (meant) left.push_back({*meant, false, h.weight, {}});
  if (std::abs(turn_rad) <= kSameArm_rad) return;
  for (std::size_t k = 0; k < floor_->nodes[by.to].arms.size(); ++k) {
    const Arm other{by.to, k};
    const bool goes_back = arm(other).edge == by.edge;
    if (other != meant && !goes_back) left.push_back({other, false, h.weight * options_.turned_wrong, {}});
  }
}

// The same place by several explanations is one.
void Whereabouts::normalise() {
  std::vector<Hypothesis> merged;
  double sum = 0.0;
  std::ranges::stable_sort(hypotheses_, [](const Hypothesis& a, const Hypothesis& b) {
    return std::tie(a.arm, a.on_node) < std::tie(b.arm, b.on_node);
  });
  for (const Hypothesis& h : hypotheses_) {
    sum += h.weight;
    const bool same = !merged.empty() && merged.back().arm == h.arm && merged.back().on_node == h.on_node;
    if (!same) {
      merged.push_back(h);
      continue;
    }
    if (h.weight > merged.back().weight) merged.back().along = h.along;
    merged.back().weight += h.weight;
  }
  std::erase_if(merged, [sum](const Hypothesis& h) { return h.weight <= kForgotten * sum; });
  for (Hypothesis& h : merged) h.weight /= sum;
  hypotheses_ = std::move(merged);
}

std::optional<Whereabouts::Belief> Whereabouts::best() const {
  const auto most = std::ranges::max_element(hypotheses_, {}, &Hypothesis::weight);
  if (most == hypotheses_.end()) return std::nullopt;
  return Belief{most->arm, most->on_node, most->weight};
}

double Whereabouts::on_node(std::string_view node) const {
  double sum = 0.0;
  for (const Hypothesis& h : hypotheses_)
    if (h.on_node && floor_->nodes[arm(h.arm).to].name == node) sum += h.weight;
  return sum;
}

}  // namespace lineservo::servo
