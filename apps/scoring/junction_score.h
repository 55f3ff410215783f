#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "apps/flight/flight_record.h"
#include "apps/scoring/junction_truth.h"
#include "apps/scoring/route_truth.h"

namespace lineservo::apps {

/// How the recogniser did, frame by frame, against the true pose; and node by node.
struct JunctionScore {
  long frames = 0;  ///< scored: on straight lines, outside take-off, turns and docking
  long misclassified = 0, held_wrong = 0, smoothed_wrong = 0;
  long ambiguous = 0;
  int events = 0;  ///< nodes of the plan that the vehicle came to
  int events_right = 0;
  std::array<std::array<long, features::kJunctionCodes>, features::kJunctionCodes> confusion =
      {};  ///< [true][raw]
  /// Of each tick: the true code, where two count the one that was seen; kNotScored.
  std::vector<std::int8_t> true_codes;
  static constexpr std::int8_t kNotScored = -1;

  double accuracy(long wrong) const;  ///< NaN without frames
};

/// `frame_period_s`: between two frames, for how far the vehicle moves meanwhile.
JunctionScore score_junctions(const FlightRecord& record, const JunctionTruth& truth, double frame_period_s);

}  // namespace lineservo::apps
