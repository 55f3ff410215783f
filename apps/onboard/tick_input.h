#pragma once

#include "servo/law/observation.h"

namespace lineservo::apps {

/// What reaches the vehicle's computer for one control tick, beside the frame itself: all that decides, with
/// the frame, what is seen and commanded. Estimates, never truth.
struct TickInput {
  servo::Time now{0};
  servo::Time captured{0};                 ///< of the frame, as far as the camera's latency is known
  bool has_frame = true;                   ///< otherwise none came in time
  servo::Time exposed{0};                  ///< the frame's own stamp
  double roll_rad = 0.0, pitch_rad = 0.0;  ///< at `captured`
  servo::StateEstimate estimate;
  bool on_ground = false;  ///< the motors stand still
};

/// A height that the laws may divide by.
inline constexpr double kLowestHeight_m = 0.05;

}  // namespace lineservo::apps
