#pragma once

#include "features/geometry/level_view.h"

namespace lineservo::features {

/// What is known of a frame besides its pixels.
struct FrameContext {
  LevelView view;             ///< from the attitude at the exposure
  double height_m = 0.5;      ///< at the exposure
  double since_last_s = 0.0;  ///< since the exposure of the frame before
  /// False while the vehicle is placed or turned on the spot: the way on is then the image's up, whatever way
  /// was followed before.
  bool on_the_way = true;
};

}  // namespace lineservo::features
