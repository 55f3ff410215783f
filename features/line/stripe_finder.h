#pragma once

#include <optional>
#include <vector>

#include "features/line/border_check.h"
#include "features/line/border_field.h"
#include "features/line/border_votes.h"
#include "features/line/side_paint.h"
#include "features/line/stripe.h"
#include "features/line/stripe_fit.h"
#include "features/mask/level_mask.h"

namespace lineservo::features {

/// Lengths in normalised units (metres on the floor over the height).
struct StripeOptions {
  int max_stripes = 6;
  double min_border_length = 0.2;  ///< of border that must support a stripe
  double min_border_widths = 0.5;  ///< the same in widths of the stripe: a disc shows 0.35 of its diameter
  double min_fill = 0.4;           ///< share of the place between the borders that is painted, worn or not
  double min_quality = 0.2;        ///< share of the visible border that must support a stripe
  double min_width = 0.015;
  double max_width = 1.8;
  double bridged_gap = 0.5;  ///< worn paint of this length does not end a stripe
  double carries_on = 0.3;   ///< a stripe of at least this length is worth following
};

/// Finds the painted stripes of a frame from the border of the paint, at any angle: directions by vote,
/// borders by vote on their offset, anti-parallel borders with paint between them as pairs, and single
/// borders where the other one is out of view. Keeps its buffers from call to call.
class StripeFinder {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit StripeFinder(const StripeOptions& options = {});

  /// Replaces `stripes` by those of the frame, the best to follow first: of those that carry on the most
  /// nearly vertical one, or with a prior the one most like it.
  void find(const LevelMask& mask, const std::vector<BorderPoint>& points,
            const std::optional<StripePrior>& prior, std::vector<Stripe>& stripes);

 private:
  struct Candidate {
    StripeCourse course;
    double score = 0.0;  ///< border that supports it; of equals the one with paint between
  };
  /// The places along a course between which border points support it.
  struct Support {
    double from = 0.0, to = 0.0;
    double middle() const { return 0.5 * (from + to); }
  };

  void search(const std::optional<StripePrior>& prior);
  void search_pairs();
  void search_single_borders(const std::optional<StripePrior>& prior);
  void search_side_paint();
  void take_arm(const Stripe& stripe, const SidePaint& paint);
  bool take_pair(double theta_rad);
  bool take_single_border(double theta_rad, double known_width);
  bool accept(const StripeCourse& start, WidthIs width, bool both_borders, double side);
  bool has_border(const StripeCourse& course, const Support& range, double side);
  bool is_on_stripe(const Eigen::Vector2d& p_L) const;
  bool is_acceptable(const Stripe& stripe) const;
  bool only_one_border_in_view(const StripeCourse& course, double side) const;
  void spend_points_of(const Stripe& stripe);
  void defer_direction(double theta_rad);
  Support support(const StripeCourse& course) const;
  double fill(const StripeCourse& course, const Support& support) const;
  double depth_in_view(const StripeCourse& border, double side) const;
  double known_width(const std::optional<StripePrior>& prior) const;
  Stripe measured(const StripeFit& fit, bool both_borders, double middle) const;

  StripeOptions options_;
  // Of the frame in hand:
  const LevelMask* mask_ = nullptr;
  std::vector<Stripe>* stripes_ = nullptr;
  BorderField border_;
  BorderCheck border_check_;
  std::vector<Candidate> candidates_;
};

}  // namespace lineservo::features
