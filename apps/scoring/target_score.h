#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "apps/flight/flight_record.h"
#include "apps/scoring/track_score.h"
#include "servo/plan/plan.h"
#include "vehicle/floor/layout.h"

namespace lineservo::apps {

/// How a flight did at one target of its plan.
struct TargetScore {
  std::string target;  ///< as the instruction calls it
  std::string node;
  Eigen::Vector2d node_W = Eigen::Vector2d::Zero();
  /// arrived, landed, wrong_node, timeout (no rest near a node); why the flight was broken off on the way
  /// there (crashed, lost_line, aborted, timeout); not_reached when that was before.
  std::string outcome;
  std::optional<Rest> rest;
  std::optional<Eigen::Vector2d> landing_W;  ///< where it stood on the ground

  bool is_reached() const { return outcome == "arrived" || outcome == "landed"; }
};

/// The targets of a plan in order; at least one.
std::vector<TargetScore> score_targets(const FlightRecord& record, const vehicle::Layout& floor,
                                       const servo::Plan& plan);

/// The outcome of the whole flight: the first thing that went wrong, else that of the last target.
std::string flight_outcome(const FlightRecord& record, const std::vector<TargetScore>& targets);

}  // namespace lineservo::apps
