#pragma once

#include <optional>
#include <vector>

#include "features/frame_features.h"
#include "features/junction/visible_arms.h"
#include "features/line/stripe.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// Lengths in normalised units (metres on the floor over the height).
struct JunctionOptions {
  double min_angle_rad = 20.0 * 3.14159265358979323846 / 180.0;  ///< between stripes that may meet
  double min_painted = 0.4;    ///< share of an arm, from the node to its end, that is painted
  double min_seen = 0.04;      ///< length of an arm, beyond the node, that must be in view
  double min_narrower = 0.04;  ///< the same of an arm that is narrower than its stripe
  double max_off = 0.08;       ///< by which a third stripe may miss the place where two meet
  double max_gap = 0.45;       ///< bare floor, worn paint, between the node and where its arm is first seen
};

/// A place where stripes meet, with what the code rule needs of its arms.
struct StripeJunction {
  JunctionFeature feature;
  std::vector<JunctionArm> arms;  ///< the same arms as in the feature, in the same order
};

/// Finds where stripes cross or meet; of several places the one nearest to the image centre.
class JunctionFinder {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit JunctionFinder(const JunctionOptions& options = {});

  std::optional<StripeJunction> find(const LevelMask& mask, const std::vector<Stripe>& stripes) const;

 private:
  void add_others(const LevelMask& mask, const std::vector<Stripe>& stripes, std::size_t a, std::size_t b,
                  StripeJunction& junction) const;
  std::optional<StripeJunction> meeting(const LevelMask& mask, const Stripe& a, const Stripe& b) const;
  /// `other`: the stripe that it crosses squarely, or none.
  int add_arms(const LevelMask& mask, const Stripe& stripe, const Stripe* other, double half_node,
               StripeJunction& junction) const;
  std::optional<JunctionArm> arm(const LevelMask& mask, const Stripe& stripe, const StripeAxes& axes,
                                 double centre_along, int way, double half_node) const;
  std::optional<JunctionArm> narrower(const LevelMask& mask, const Stripe& stripe, double from,
                                      double centre_along, int way) const;

  JunctionOptions options_;
};

}  // namespace lineservo::features
