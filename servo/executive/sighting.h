#pragma once

#include <Eigen/Core>
#include <optional>

#include "servo/law/observation.h"
#include "servo/plan/plan.h"

namespace lineservo::servo {

/// Where the frame shows a red disc: the start marker, or one on a node. Heading frame at the frame's
/// capture, metres.
std::optional<Eigen::Vector2d> disc_sighting(const Observation& o);

/// Where the frame shows the node that the step expects: its disc, the junction's centre, or a dead end's
/// end. Heading frame at the frame's capture, metres.
std::optional<Eigen::Vector2d> node_sighting(const Observation& o, const PlanStep* step);

/// The reading with a disc only where one is expected, and near: its first sliver says little of its middle.
features::CodeReading near_reading(const Observation& o, const PlanStep* step);

}  // namespace lineservo::servo
