#pragma once

#include <optional>
#include <vector>

#include "features/line/stripe.h"

namespace lineservo::features {

/// The cap of a dead end lies so near to the end, in normalised units.
inline constexpr double kBesideEnd = 0.05;

/// The same paint as one of these, seen at nearly the same angle: what is left over of a bent or ragged
/// stripe.
bool is_paint_of(const std::vector<Stripe>& stripes, const Stripe& stripe);

/// Takes out the pieces that start and end inside a longer stripe, as worn paint shows them between a gap and
/// a blotch, or at a cap; says whether there were any. A piece that leaves the view beside that stripe goes
/// on: it is a side arm of which little is in view.
bool drop_wear(std::vector<Stripe>& stripes);

/// The best to follow first: of those at least as long as `carries_on` the most nearly vertical one, or with
/// a prior the one most like it.
void rank(std::vector<Stripe>& stripes, const std::optional<StripePrior>& prior, double carries_on);

}  // namespace lineservo::features
