#include "servo/plan/route.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

using features::wrap_angle;

/// Compared in this order; the length in whole millimetres, so that rounding cannot break a tie.
struct Cost {
  long length_mm = 0;
  int turns = 0;
  int first_heading_mrad = 0;

  friend auto operator<=>(const Cost&, const Cost&) = default;
};

/// A traveller on the arm `arm` of the node `from`, about to reach the arm's other end.
struct State {
  std::size_t from = 0;
  std::size_t arm = 0;

  friend auto operator<=>(const State&, const State&) = default;
};

constexpr double kTurn_rad = 0.35;  // a change of heading that counts as a turn

const TopologyArm& taken(const Topology& topology, State state) {
  return topology.nodes[state.from].arms[state.arm];
}

long length_mm(const Topology& topology, const TopologyArm& arm) {
  return std::lround(1000.0 * topology.edges[arm.edge].length_m);
}

Cost first_cost(const Topology& topology, const TopologyArm& arm, std::optional<double> facing_rad) {
  const double off_rad = std::abs(wrap_angle(arm.heading_rad - facing_rad.value_or(0.0)));
  const int turns = facing_rad && off_rad > kTurn_rad ? 1 : 0;
  return {length_mm(topology, arm), turns, static_cast<int>(std::lround(1000.0 * off_rad))};
}

Cost onward_cost(const Topology& topology, Cost cost, const TopologyArm& from, const TopologyArm& onto) {
  const double turn_rad = wrap_angle(onto.heading_rad - from.arrival_heading_rad);
  cost.length_mm += length_mm(topology, onto);
  cost.turns += std::abs(turn_rad) > kTurn_rad ? 1 : 0;
  return cost;
}

Route trace(const Topology& topology, const std::map<State, State>& previous, State last) {
  Route route{taken(topology, last)};
  for (auto it = previous.find(last); it != previous.end(); it = previous.find(it->second)) {
    route.push_back(taken(topology, it->second));
  }
  std::reverse(route.begin(), route.end());
  return route;
}

}  // namespace

std::optional<Route> shortest_route(const Topology& topology, std::size_t start, std::size_t target,
                                    std::optional<double> facing_rad) {
  using Entry = std::pair<Cost, State>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::map<State, Cost> best;
  std::map<State, State> previous;
  const auto reach = [&](State state, Cost cost) {
    const auto [it, is_new] = best.try_emplace(state, cost);
    if (!is_new && it->second <= cost) return false;
    it->second = cost;
    open.emplace(cost, state);
    return true;
  };
  for (std::size_t arm = 0; arm < topology.nodes[start].arms.size(); ++arm) {
    reach({start, arm}, first_cost(topology, topology.nodes[start].arms[arm], facing_rad));
  }
  while (!open.empty()) {
    const auto [cost, state] = open.top();
    open.pop();
    if (best.at(state) < cost) continue;
    const TopologyArm& arm = taken(topology, state);
    if (arm.to == target) return trace(topology, previous, state);
    const auto& onward = topology.nodes[arm.to].arms;
    for (std::size_t next = 0; next < onward.size(); ++next) {
      if (onward[next].edge == arm.edge) continue;
      const State next_state{arm.to, next};
      if (reach(next_state, onward_cost(topology, cost, arm, onward[next]))) previous[next_state] = state;
    }
  }
  return std::nullopt;
}

}  // namespace lineservo::servo
