#pragma once

#include <functional>
#include <vector>

#include "features/line/stripe.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// A place where paint leaves a stripe to a side.
struct SidePaint {
  double along = 0.0;  ///< of the stripe's axes: middle of what would be an arm of the stripe's own width
  double side = 1.0;   ///< +1 towards the normal, −1 away from it
  double away = 0.0;   ///< where the paint that was seen begins, from the stripe's centreline
};

/// Finds, by the area of the paint beside a stripe, where arms of the stripe's own width leave it. Worn
/// borders say little of a short arm; its paint, three quarters of the place that it takes, is plain beside
/// bare floor. `is_known` tells the places that another stripe explains. At most one place a side.
std::vector<SidePaint> side_paint(const LevelMask& mask, const Stripe& stripe,
                                  const std::function<bool(const Eigen::Vector2d&)>& is_known);

}  // namespace lineservo::features
