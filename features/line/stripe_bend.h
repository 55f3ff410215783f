#pragma once

#include <optional>
#include <vector>

#include "features/line/border_points.h"
#include "features/line/stripe.h"

namespace lineservo::features {

/// When a stripe counts as bent.
struct BendOptions {
  double reach = 0.15;        ///< how far from the straight stripe's borders a bent one may run
  double significance = 6.0;  ///< standard deviations that a curvature must stand out
  double least_sag = 0.008;   ///< of the arc over its chord in view: less is taken for straight
};

/// The stripe as a line that bends: its tangent at the place nearest to the point below the camera, and the
/// curvature, from the border points of the mask. None where the stripe is straight. Lengths in normalised
/// units.
std::optional<LineFeature> fit_bend(const std::vector<BorderPoint>& points, const Stripe& stripe,
                                    const BendOptions& options = {});

}  // namespace lineservo::features
