#pragma once

#include <optional>

#include "servo/plan/plan.h"

namespace lineservo::servo {

/// The same way for a law that pursues the line without control of the heading (vtp §3): one step, from
/// take-off to the disc at the end, without turns and without codes on the way. None when the way passes a
/// branch, which the line alone cannot decide, does not end on a disc, which it would fly past, or has
/// targets in between.
std::optional<Plan> pursuit_of(const Plan& plan, const Topology& topology);

}  // namespace lineservo::servo
