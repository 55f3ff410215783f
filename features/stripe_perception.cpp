#include "features/stripe_perception.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "features/line/stripe_extent.h"

namespace lineservo::features {
namespace {

constexpr double kSameWay_rad = radians(10.0);
constexpr double kAhead_rad = radians(60.0);  // beyond, a corner is told by the line's end
constexpr double kOnCourse = 0.05;  // a junction of the stripe lies so near to its centreline

// Half of what the stripes that cross the first one at a place take up of it.
double half_node_along(const std::vector<Stripe>& stripes, const Eigen::Vector2d& centre_L) {
  double half = 0.0;
  for (const Stripe& stripe : stripes) {
    const double sine = std::abs(std::sin(stripe.course.theta_rad - stripes.front().course.theta_rad));
    const bool crosses = std::abs(StripeAxes(stripe.course).across(centre_L)) < kOnCourse && sine > 0.3;
    if (crosses) half = std::max(half, 0.5 * stripe.course.width / sine);
  }
  return half;
}

}  // namespace

StripePerception::StripePerception(const MaskGeometry& geometry, const StripePerceptionOptions& options)
    : geometry_(geometry),
      options_(options),
      border_(options.border),
      stripe_finder_(options.stripe),
      junction_finder_(options.junction) {
  if (!(options.certain_end >= 0.0) || !(options.junction_end >= 0.0))
    throw std::invalid_argument("stripe perception: lengths of ends must not be negative");
}

const StripeFeatures& StripePerception::observe(const MaskView& mask, const LevelView& view,
                                                const std::optional<StripePrior>& prior) {
  if (mask.width != geometry_.width_px() || mask.height != geometry_.height_px())
    throw std::invalid_argument("stripe perception: the mask has another size than the geometry");
  const LevelMask level_mask(mask, geometry_, view);
  border_.extract(level_mask, points_);
  stripe_finder_.find(level_mask, points_, prior, stripes_);
  const auto junction = junction_finder_.find(level_mask, stripes_);

  features_.lines.clear();
  for (const Stripe& stripe : stripes_) features_.lines.push_back(stripe.feature);
  if (!stripes_.empty()) {
    if (const auto bent = fit_bend(points_, stripes_.front(), options_.bend)) features_.lines.front() = *bent;
  }
  features_.junction.reset();
  features_.arms = {};
  if (junction) {
    features_.junction = junction->feature;
    features_.arms = visible_arms(level_mask, junction->feature.centre, junction->arms, options_.visibility);
  }
  features_.raw = code();
  features_.line_ends_ahead = ends_ahead(level_mask, junction);
  features_.line_end.reset();
  if (!stripes_.empty() && !stripes_.front().end.leaves_view &&
      stripes_.front().end.bare >= options_.possible_end && !goes_on(junction, kSameWay_rad))
    features_.line_end = stripes_.front().feature.end;
  return features_;
}

// An edge without a node in view is J2; so is one whose node shows no arm yet.
JunctionCode StripePerception::code() const {
  if (features_.lines.empty()) return JunctionCode::unrecognised;
  return features_.arms == Arms{} ? JunctionCode::straight : code_of(features_.arms);
}

// Past the end of the stripe that is followed an arm leads on: narrower than it, or at an angle, as on a
// curve.
bool StripePerception::goes_on(const std::optional<StripeJunction>& junction, double within_rad) const {
  constexpr double kFurther = 0.1;
  if (!junction) return false;
  const Stripe& followed = stripes_.front();
  const Eigen::Vector2d forward = followed.course.forward();
  const double heading_rad = std::atan2(-forward.x(), -forward.y());
  const double end =
      followed.end.along - StripeAxes(followed.course).along(junction->feature.centre.vector());
  return std::any_of(junction->arms.begin(), junction->arms.end(), [&](const JunctionArm& arm) {
    return std::abs(wrap_angle(arm.feature.angle_rad - heading_rad)) < within_rad &&
           arm.feature.length + 0.5 * arm.width > end + kFurther;
  });
}

bool StripePerception::ends_ahead(const LevelMask& mask,
                                  const std::optional<StripeJunction>& junction) const {
  if (stripes_.empty()) return false;
  const Stripe& followed = stripes_.front();
  if (goes_on(junction, kAhead_rad)) return false;
  if (followed.end.bare >= options_.certain_end)
    return junction || !paint_bends_away(mask, followed.course, followed.end.along);
  return junction && stops_at(mask, junction->feature);
}

// Worn paint is bare in places as well, even next to a node: so the whole width counts, over some length past
// the node, and a spot of paint there is forgiven.
bool StripePerception::stops_at(const LevelMask& mask, const JunctionFeature& junction) const {
  constexpr double kStep = 0.02, kSpots = 0.12, kBeyondNode = 0.02;
  const StripeAxes axes(stripes_.front().course);
  const double half_node = half_node_along(stripes_, junction.centre.vector()) + kBeyondNode;
  if (std::abs(axes.across(junction.centre.vector())) > kOnCourse) return false;
  const double needed = std::clamp(options_.clear_end - half_node, options_.junction_end, 0.2);
  const double from = axes.along(junction.centre.vector()) + half_node;
  double seen = 0.0;
  int in_view = 0, painted = 0;
  for (double gone = 0.5 * kStep; gone < options_.certain_end; gone += kStep) {
    const CrossSection section = cross_section(mask, axes, from + gone);
    if (section.is_out_of_view()) break;
    seen += kStep;
    in_view += section.in_view;
    painted += section.painted;
  }
  return seen >= needed && painted <= kSpots * in_view;
}

}  // namespace lineservo::features
