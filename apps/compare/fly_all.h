#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "apps/flight/mission.h"
#include "apps/report/flight_trace.h"

namespace lineservo::apps {

/// A mission that is to be flown with a seed.
struct FlightTask {
  const Mission* mission;
  std::uint64_t seed;
  const Settings* settings = nullptr;  ///< in the place of the mission's; null: those
  FlightTrace* trace = nullptr;        ///< where to keep what draws the flight; null: nowhere
};

/// Flies all of them on so many threads; the summaries are in the order of the tasks and, but for the
/// timings, the same for any number. `watch` is called now and then with how many are done; when it returns
/// false all are broken off and there is no result.
std::optional<std::vector<FlightSummary>> fly_all(const std::vector<FlightTask>& tasks, int jobs,
                                                  const std::function<bool(std::size_t done)>& watch);

}  // namespace lineservo::apps
