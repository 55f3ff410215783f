#pragma once

#include <chrono>
#include <cmath>

#include "features/frame_features.h"
#include "features/geometry/angles.h"
#include "servo/law/motion.h"
#include "servo/law/state_estimate.h"

namespace lineservo::servo {

using Time = std::chrono::nanoseconds;

constexpr double seconds(Time t) {
  return static_cast<double>(t.count()) * 1e-9;
}

/// All that a law may know at one control tick. Estimates, never truth.
struct Observation {
  Time now{0};
  Time captured{0};  ///< mid-exposure of the frame, as far as the camera's latency is known
  features::FrameFeatures features;
  bool has_frame = true;  ///< otherwise none came in time, and the features are empty
  StateEstimate estimate;
};

/// What the vehicle moved since the frame was taken.
inline Motion since_capture(const Observation& o) {
  return between(o.estimate.odometry_at_capture, o.estimate.odometry_now);
}

/// A line that lies further than this across the way leads elsewhere: a side arm that is alone in view.
inline constexpr double kFollowable_rad = features::radians(60.0);

/// The line to follow, or none. One whose values are not finite counts as not seen.
inline const features::LineFeature* line_to_follow(const Observation& o) {
  const features::LineFeature* line = o.features.line();
  const bool usable = line && std::isfinite(line->rho) && std::abs(line->theta_rad) <= kFollowable_rad;
  return usable ? line : nullptr;
}

}  // namespace lineservo::servo
