#pragma once

#include <optional>

#include "servo/law/observation.h"
#include "servo/task/command.h"

namespace lineservo::servo {

/// What the executive asks of a follower.
struct FollowGoal {
  double speed_m_s = 0.1;  ///< along the line
  double height_m = 0.5;
  bool curved = false;          ///< the edge that is followed bends
  double yaw_rate_rad_s = 0.0;  ///< with which the executive holds the heading, for laws that do not steer it
};

/// What the executive has to do for a law.
struct LawTraits {
  bool servos_on_node =
      true;  ///< docks on nodes; otherwise it stops where the code is confirmed, as its paper does
  bool steers_heading =
      true;  ///< otherwise the executive holds the heading on the line, in the place of a compass
  bool yaws_on_bends =
      false;  ///< on an edge that bends the law's own yaw counts, whatever holds it elsewhere
  bool pursues_line =
      false;  ///< it needs no heading: a line without branches it follows to the end by itself
};

/// A law that follows a line: features in, command out. Knows no plan, no clock, no camera. Features lie in
/// the level camera L as it was when the frame was taken, commands in the heading frame H as it is now
/// (servo/conventions.md has the axes and signs). To add one of one's own: add_controller().
class FollowLaw {
 public:
  virtual ~FollowLaw() = default;
  /// Forgets what it has accumulated on the leg before.
  virtual void reset() = 0;
  /// One control tick: with every frame, and without one where none came in time. Without a line in view it
  /// keeps the vehicle level and sideways at rest. What it says is limited by the executive, which brakes
  /// when a value is not finite.
  virtual Command follow(const Observation& observation, const FollowGoal& goal) = 0;
  /// One tick above the target, for laws whose paper holds a place there. None: the vehicle brakes and stays.
  virtual std::optional<Command> hover(const Observation&, const FollowGoal&) { return std::nullopt; }
};

}  // namespace lineservo::servo
