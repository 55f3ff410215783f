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

/// Five samples across the stripe, at `along` of StripeCourse::at.
CrossSection cross_section(const LevelMask& mask, const StripeCourse& course, double along);

/// Follows the paint from `along` one way (+1 forward, −1 back) to where it stops or leaves the view. Bare
/// stretches of up to `bridged` are worn paint when paint follows them.
StripeEnd follow_paint(const LevelMask& mask, const StripeCourse& course, double along, int way,
                       double bridged);

/// The length of both borders that lies in view between two places along the stripe.
double border_in_view(const LevelMask& mask, const StripeCourse& course, double from, double to);

}  // namespace lineservo::features
