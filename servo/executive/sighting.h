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

/// The dead end that the step expects, at whatever angle its line lies while the vehicle turns over it: of
/// all ends of lines the one nearest to where it must be. Heading frame at the frame's capture, metres.
std::optional<Eigen::Vector2d> dead_end_sighting(const Observation& o, const PlanStep* step,
                                                 const std::optional<Eigen::Vector2d>& where_m);

/// How the line bends at the junction in view, where the step expects a bend.
Bend bend_sighting(const Observation& o, const PlanStep* step);

/// The published way to notice a bend, which turns where it notices (topology §2.5): the path's centroid,
/// having been in the middle, lies more than 45 of 400 px to a side.
class CentroidBend {
 public:
  /// `leaving`: the node behind is still in view and moves the centroid.
  Bend update(const Observation& o, const PlanStep* step, bool leaving);

 private:
  bool was_on_line_ = false;
};

/// The reading with a disc only where one is expected, and near: its first sliver says little of its middle.
/// Where a bend is expected the line's end is the bend.
features::CodeReading near_reading(const Observation& o, const PlanStep* step);

}  // namespace lineservo::servo
