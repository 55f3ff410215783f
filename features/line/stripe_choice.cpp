#include "features/line/stripe_choice.h"

#include <algorithm>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kSameDirection_rad = radians(20.0);
constexpr double kOffsetWeight_rad = 0.1;  // one unit of offset counts as so much of direction

double length(const Stripe& stripe) {
  return stripe.end.along - stripe.begin.along;
}

bool lies_within(const Stripe& whole, const LevelPoint& p, bool leaves_view) {
  const StripeAxes axes(whole.course);
  const double margin = leaves_view ? kBesideEnd : std::max(kBesideEnd, 0.2 * whole.course.width);
  const double along = axes.along(p.vector());
  return std::abs(axes.across(p.vector())) < 0.5 * whole.course.width + margin &&
         along > whole.begin.along - kBesideEnd && along < whole.end.along + kBesideEnd;
}

bool is_piece_of(const Stripe& whole, const Stripe& piece) {
  return length(piece) < length(whole) && lies_within(whole, piece.feature.begin, piece.begin.leaves_view) &&
         lies_within(whole, piece.feature.end, piece.end.leaves_view);
}

double unlikeness(const Stripe& stripe, const StripePrior& expected) {
  const double turn = wrap_angle(stripe.course.theta_rad - expected.theta_rad);
  const bool mirrored = std::abs(turn) > kPi / 2.0;
  const double rho = mirrored ? -stripe.course.rho : stripe.course.rho;
  return axis_difference(stripe.course.theta_rad, expected.theta_rad) +
         kOffsetWeight_rad * std::abs(rho - expected.rho);
}

}  // namespace

bool is_paint_of(const std::vector<Stripe>& stripes, const Stripe& stripe) {
  const Eigen::Vector2d middle =
      StripeAxes(stripe.course).at(0.5 * (stripe.begin.along + stripe.end.along), 0.0);
  return std::any_of(stripes.begin(), stripes.end(), [&](const Stripe& other) {
    if (axis_difference(stripe.course.theta_rad, other.course.theta_rad) > kSameDirection_rad) return false;
    const double apart = std::abs(middle.dot(other.course.normal()) - other.course.rho);
    return apart < 0.5 * (stripe.course.width + other.course.width);
  });
}

bool drop_wear(std::vector<Stripe>& stripes) {
  const std::size_t found = stripes.size();
  for (auto piece = stripes.begin(); piece != stripes.end();) {
    const bool is_wear = std::any_of(stripes.begin(), stripes.end(),
                                     [&](const Stripe& whole) { return is_piece_of(whole, *piece); });
    piece = is_wear ? stripes.erase(piece) : piece + 1;
  }
  return stripes.size() < found;
}

void rank(std::vector<Stripe>& stripes, const std::optional<StripePrior>& prior, double carries_on) {
  const StripePrior expected = prior.value_or(StripePrior{});
  std::stable_sort(stripes.begin(), stripes.end(), [&](const Stripe& a, const Stripe& b) {
    const bool a_carries_on = length(a) >= carries_on, b_carries_on = length(b) >= carries_on;
    if (a_carries_on != b_carries_on) return a_carries_on;
    return unlikeness(a, expected) < unlikeness(b, expected);
  });
}

}  // namespace lineservo::features
