#pragma once

#include <optional>
#include <vector>

#include "features/line/border_points.h"
#include "features/line/stripe.h"

namespace lineservo::features {

/// A stripe whose borders need not be parallel: a painted line seen at a slant. Its centreline is half-way
/// between them.
struct Wedge {
  StripeCourse course;       ///< of the centreline; the width is that at `at_along`
  double convergence = 0.0;  ///< change of the width per length along the stripe, forward
  double at_along = 0.0;     ///< of StripeAxes
  double support = 0.0;      ///< length of border that lies on the two fitted borders
  double scatter = 0.0;      ///< of the border points about them, one σ
};

/// How far borders may converge and turn.
struct WedgeOptions {
  double max_convergence = 0.5;                                 ///< borders that meet at up to 28°
  double max_turn_rad = 12.0 * 3.14159265358979323846 / 180.0;  ///< from the stripe that it starts from
};

/// Refines a stripe that was found with parallel borders, from the border points between its ends. None
/// when too little border supports a wedge, or it strays from the stripe.
std::optional<Wedge> fit_wedge(const std::vector<BorderPoint>& points, const StripeCourse& start, double from,
                               double to, const WedgeOptions& options = {});

}  // namespace lineservo::features
