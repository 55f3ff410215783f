#pragma once

#include <Eigen/Core>
#include <vector>

#include "features/frame_features.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// A painted arm with what the visibility rule needs.
struct JunctionArm {
  ArmFeature feature;
  double width = 0.0;       ///< of its stripe
  bool leaves_view = true;  ///< its paint goes on to the edge of the image
};

/// When an arm counts as visible, in pixels of the resized 400×400 frame.
struct ArmVisibility {
  double min_px = 20.0;  ///< the arm beyond the node's square measures at least this along x and along y
  /// Less than this is asked of the side across the arm: 50 mm tape seen from 0.5 m measures 20.0 px, and a
  /// code that flickers with the last tenth of a pixel helps nobody. Either code counts as right within 4 px.
  double across_slack_px = 3.0;
  double max_off_axis_rad = 25.0 * 3.14159265358979323846 / 180.0;  ///< from F, B, L or R
};

/// Size in mask pixels, along x and along y, of the part in view of the rectangle that an arm covers beyond
/// the node's square; (0, 0) if none of it is in view.
Eigen::Vector2d visible_arm_size_px(const LevelMask& mask, LevelPoint centre, const JunctionArm& arm);

/// Which of a junction's arms are visible by the rule of codes.md.
Arms visible_arms(const LevelMask& mask, LevelPoint centre, const std::vector<JunctionArm>& arms,
                  const ArmVisibility& rule = {});

}  // namespace lineservo::features
