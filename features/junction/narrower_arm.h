#pragma once

#include <optional>

#include "features/line/stripe.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// A line that goes on narrower where a stripe ends: its width, and where it ends.
struct NarrowerArm {
  double width = 0.0;
  StripeEnd end;  ///< along the axes of the stripe
};

/// Looks for it from `from` along a stripe's axes, one way (+1 forward, −1 back): paint about the centreline
/// with bare floor on both sides of it within the stripe's width, of one width for some length.
std::optional<NarrowerArm> narrower_arm(const LevelMask& mask, const StripeCourse& course, double from,
                                        int way);

/// How far unbroken paint reaches from a stripe's centreline to one side (+1 along the normal, −1), up to a
/// bound; none where that is out of view.
std::optional<double> painted_to(const LevelMask& mask, const StripeAxes& axes, double along, double side,
                                 double bound);

}  // namespace lineservo::features
