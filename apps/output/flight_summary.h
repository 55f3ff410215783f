#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/config/flight_request.h"
#include "apps/flight/flight_record.h"
#include "apps/scoring/hold_score.h"
#include "apps/scoring/junction_score.h"
#include "apps/scoring/target_score.h"
#include "apps/scoring/track_score.h"

namespace lineservo::apps {

/// A flight and all that was found out about it: what summary.json holds.
struct FlightSummary {
  std::string outcome;  ///< arrived, landed, lost_line, wrong_node, timeout, crashed, aborted
  std::string target;
  Eigen::Vector2d target_W = Eigen::Vector2d::Zero();
  std::optional<Rest> rest;          ///< at the last target, as those above
  std::vector<TargetScore> targets;  ///< of a mission all of them
  double duration_s = 0.0;
  double distance_m = 0.0;
  double tilt_rate_rms_rad_s = 0.0;
  HoldScore hold{};
  TrackScore track;
  JunctionScore junctions;
  FlightTiming timing;
  std::string trajectory_sha256;

  bool succeeded() const { return outcome == "arrived" || outcome == "landed"; }
};

FlightSummary summarise(const FlightRequest& request, const vehicle::Layout& floor, const servo::Plan& plan,
                        const FlightRecord& record);

/// Numbers, or null where not applicable. `targets` is there for a mission only.
nlohmann::ordered_json to_json(const FlightRequest& request, const FlightSummary& summary);

}  // namespace lineservo::apps
