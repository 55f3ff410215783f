#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/flight/mission.h"
#include "vehicle/random.h"

namespace lineservo::apps {

/// One thing that goes wrong, in a flight of its own.
struct FaultCase {
  std::string name;
  /// The settings that bring it about in a mission, as KEY=VALUE: when and where is drawn.
  std::function<std::vector<std::string>(const Mission& mission, vehicle::Random& random)> draw;
};

/// All faults of `evaluate faults`.
const std::vector<FaultCase>& fault_cases();

}  // namespace lineservo::apps
