#pragma once

#include <Eigen/Core>
#include <cmath>

#include "servo/law/follow_law.h"

// What the followers of lfpf share: their frame, and how their pitch is carried over to a wanted speed.

namespace lineservo::servo {

/// The pixel constants of lfpf hold for its frame of 640×480 with f = 320 px: normalised units to such
/// pixels.
inline constexpr double kPublishedFocal_px = 320.0;

/// A point of the image in the pixels of lfpf, from the image's centre: forward (up in the image), left.
inline Eigen::Vector2d published_px(const features::LevelPoint& p) {
  return kPublishedFocal_px * Eigen::Vector2d(-p.y, -p.x);
}

/// Level, at the wanted height, without turning: what is commanded when nothing is seen.
inline AttitudeCommand level_flight(const FollowGoal& goal) {
  return {0.0, 0.0, 0.0, goal.height_m};
}

/// Nothing but the line in view: no junction, no start marker. lfpf knows of neither. There its followers act
/// on the line that the executive's recogniser leads along, in the place of their own feature, and without it
/// go straight on.
inline bool on_plain_line(const Observation& o) {
  return o.features.code.smoothed == features::JunctionCode::straight;
}

/// Ours, not the paper's: pitch for the difference between the wanted and the estimated speed. The published
/// pitch is as small as the error of the attitude estimate. 0 without an estimate or a gain.
inline double speed_hold(const Observation& o, double speed_m_s, double gain_rad_per_m_s) {
  const double off_m_s = speed_m_s - o.estimate.v_H_m_s.x();
  return std::isfinite(off_m_s) ? gain_rad_per_m_s * off_m_s : 0.0;
}

}  // namespace lineservo::servo
