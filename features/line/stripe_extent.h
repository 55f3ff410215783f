#pragma once

#include "features/line/stripe.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// How much of a stripe's cross-section is painted.
struct CrossSection {
  int in_view = 0;
  int painted = 0;

  bool is_out_of_view() const { return in_view == 0; }
  bool is_painted() const { return 2 * painted > in_view; }
};

/// Samples across the stripe at `along` of StripeAxes, more of them on a broad one; those near its borders only
/// where others are out of view.
CrossSection cross_section(const LevelMask& mask, const StripeAxes& axes, double along);

/// Follows the paint from `along` one way (+1 forward, −1 back) to where it stops or leaves the view. Bare
/// stretches of up to `bridged` are worn paint when paint follows them.
StripeEnd follow_paint(const LevelMask& mask, const StripeAxes& axes, double along, int way, double bridged);

/// Whether paint goes on to the side of where a stripe ends ahead, as a bend does past its tangent. A dead
/// end has none within 75° of forward at a stripe's width.
bool paint_bends_away(const LevelMask& mask, const StripeCourse& course, double end_along);

/// The length of both borders that lies in view between two places along the stripe.
double border_in_view(const LevelMask& mask, const StripeAxes& axes, double from, double to);

}  // namespace lineservo::features
