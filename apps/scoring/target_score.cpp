#include "apps/scoring/target_score.h"

#include <algorithm>
#include <utility>

#include "apps/scoring/route_truth.h"

namespace lineservo::apps {
namespace {

using servo::AbortReason;
using servo::Phase;

/// The node within the arrival radius of a place, or none.
std::optional<std::size_t> node_at(const vehicle::Layout& floor, const Eigen::Vector2d& p_W) {
  for (std::size_t i = 0; i < floor.nodes.size(); ++i) {
    if ((floor.nodes[i].p_W - p_W).norm() <= kArrivalRadius_m) return i;
  }
  return std::nullopt;
}

/// Why the flight was broken off; empty when it was not.
std::string broken_off(const FlightRecord& record) {
  if (record.crashed) return "crashed";
  if (record.abort_reason == AbortReason::line_lost) return "lost_line";
  const bool ran_out =
      record.abort_reason == AbortReason::node_overdue || record.abort_reason == AbortReason::out_of_time;
  if (ran_out) return "timeout";
  if (record.abort_reason != AbortReason::none || record.interrupted) return "aborted";
  return record.out_of_time ? "timeout" : "";
}

std::optional<Eigen::Vector2d> landing_at(const FlightRecord& record, int step, bool is_last) {
  if (is_last) {
    const bool ended_there = record.landed && !record.truth.empty() && record.truth.back().step == step;
    return ended_there ? std::optional<Eigen::Vector2d>(record.truth.back().p_WB.head<2>()) : std::nullopt;
  }
  const auto it = std::find_if(record.truth.begin(), record.truth.end(), [step](const TruthSample& s) {
    return s.phase == Phase::rest && s.step == step;
  });
  return it == record.truth.end() ? std::nullopt : std::optional<Eigen::Vector2d>(it->p_WB.head<2>());
}

std::string outcome_at(const TargetScore& score, const vehicle::Layout& floor, std::size_t target) {
  if (!score.rest) return "timeout";
  const std::optional<std::size_t> node =
      node_at(floor, score.landing_W.value_or(Eigen::Vector2d(score.rest->x_m, score.rest->y_m)));
  if (node == target) return score.landing_W ? "landed" : "arrived";
  return node ? "wrong_node" : "timeout";
}

TargetScore score_at(const FlightRecord& record, const vehicle::Layout& floor, const servo::Plan& plan,
                     std::size_t index, std::size_t node) {
  const int step = static_cast<int>(index);
  TargetScore score;
  score.target = plan.steps[index].target;
  score.node = plan.steps[index].node;
  score.node_W = floor.nodes[node].p_W;
  score.rest = find_rest(record, step, score.node_W);
  score.landing_W = landing_at(record, step, index + 1 == plan.steps.size());
  score.outcome = outcome_at(score, floor, node);
  return score;
}

}  // namespace

std::vector<TargetScore> score_targets(const FlightRecord& record, const vehicle::Layout& floor,
                                       const servo::Plan& plan) {
  const RouteTruth route = route_truth(floor, plan);
  const std::string fault = broken_off(record);
  const int last_step = record.truth.empty() ? 0 : record.truth.back().step;
  bool is_broken_off = false;
  std::vector<TargetScore> scores;
  for (const std::size_t index : servo::target_steps(plan)) {
    TargetScore score = score_at(record, floor, plan, index, route.nodes[index]);
    if (!fault.empty() && last_step <= static_cast<int>(index))
      score.outcome = std::exchange(is_broken_off, true) ? "not_reached" : fault;
    scores.push_back(std::move(score));
  }
  return scores;
}

std::string flight_outcome(const FlightRecord& record, const std::vector<TargetScore>& targets) {
  if (const std::string fault = broken_off(record); !fault.empty()) return fault;
  const auto missed =
      std::find_if(targets.begin(), targets.end(), [](const TargetScore& t) { return !t.is_reached(); });
  return missed == targets.end() ? targets.back().outcome : missed->outcome;
}

}  // namespace lineservo::apps
