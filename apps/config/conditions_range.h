#pragma once

#include <optional>
#include <string>

#include "apps/config/flight_request.h"

namespace lineservo::apps {

/// Conditions between two others: "paper..harsh".
struct ConditionsRange {
  std::string from, to;  ///< names that ship, or files
};

/// None when the text is no such pair. Dots of a path ("../mine.yaml") do not count.
std::optional<ConditionsRange> conditions_range(const std::string& text);

/// Draws conditions between the two from the request's seed: how far towards `to` (uniform), and for each
/// group of settings (camera, floor, light, wind, …: the first word of their keys; those without a group each
/// by itself) whether it goes there at all or stays at `from` (one half). A number lies so far between the
/// two; anything else is that of the nearer end. Throws InputError.
void draw_conditions(FlightRequest& request, const ConditionsRange& range);

}  // namespace lineservo::apps
