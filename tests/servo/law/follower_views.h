#pragma once

#include <limits>
#include <variant>

#include "servo/law/follow_law.h"
#include "tests/servo/test_pose.h"

// What the published followers see, for their tests.

namespace lineservo::servo::testing {

inline constexpr FollowGoal kFollowerGoal{0.1, 0.5};
inline constexpr double kFocal_px = 320.0;

/// A point of the image in pixels of 640×480 off its centre, x right, y down.
inline features::LevelPoint at_px(double x, double y) {
  return {x / kFocal_px, y / kFocal_px};
}

/// A frame without anything in it, at the wanted height and speed.
inline Observation empty_view(features::JunctionCode code = features::JunctionCode::straight) {
  Observation o;
  o.features.code.smoothed = code;
  o.estimate.height_m = o.estimate.capture_height_m = kFollowerGoal.height_m;
  o.estimate.v_H_m_s.x() = kFollowerGoal.speed_m_s;
  return o;
}

/// The law's own line, through two points in pixels off the centre, the lower one first.
inline Observation line_view(features::LevelPoint lower, features::LevelPoint upper) {
  Observation o = empty_view();
  o.features.law.lines = {line_through(lower, upper)};
  return o;
}

/// The centres of the path on the image's boundary.
inline Observation boundary_view(features::LevelPoint behind, features::LevelPoint ahead) {
  Observation o = empty_view();
  o.features.law.behind = behind;
  o.features.law.ahead = ahead;
  return o;
}

inline AttitudeCommand attitude(FollowLaw& law, const Observation& o,
                                const FollowGoal& goal = kFollowerGoal) {
  return std::get<AttitudeCommand>(law.follow(o, goal));
}

}  // namespace lineservo::servo::testing
