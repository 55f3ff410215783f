#include "features/line/stripe_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "features/geometry/angles.h"
#include "features/line/side_paint.h"
#include "features/line/stripe_choice.h"
#include "features/line/stripe_extent.h"

namespace lineservo::features {
namespace {

constexpr int kRounds = 10;           // directions tried in each pass
constexpr double kPeakLength = 0.06;  // of border, for an offset to count
constexpr double kNear = 0.03;        // of a border: three bins of the vote
constexpr double kOwn = 0.02;         // of a fitted border: its points
constexpr double kFacing = 0.966;     // of the angle that follows
constexpr double kFacing_rad = radians(15.0);
constexpr double kBeside = 0.015;               // a stripe: what is still taken for its paint
constexpr double kWhole = 0.95;                 // share of a stripe that is painted where no paint is worn
constexpr double kLeastArm = 0.1;               // length of an arm, node included
constexpr double kArmTurn_rad = radians(12.0);  // of an arm from square, as its borders may say
constexpr double kArmSigma = 0.03, kArmSigma_rad = 0.1;  // of an arm whose borders say nothing
constexpr double kUnhinted = 0.5;      // border length for a stripe whose width nobody knows
constexpr double kGuessQuality = 0.3;  // factor when the width is a guess
constexpr double kTried_rad = radians(5.0);

void require(bool holds, const char* fault) {
  if (!holds) throw std::invalid_argument(std::string("stripe options: ") + fault);
}

}  // namespace

StripeFinder::StripeFinder(const StripeOptions& options) : options_(options) {
  require(options.max_stripes >= 1 && options.max_stripes <= 32, "max_stripes must be 1 to 32");
  require(options.min_border_length > 0.0, "min_border_length must be positive");
  require(options.min_border_widths >= 0.0, "min_border_widths must not be negative");
  require(options.min_fill > 0.0 && options.min_fill <= 1.0, "min_fill must be in (0, 1]");
  require(options.min_width > 0.0 && options.min_width < options.max_width,
          "min_width must be positive and below max_width");
  require(options.min_quality >= 0.0 && options.min_quality <= 1.0, "min_quality must be in [0, 1]");
  require(options.bridged_gap >= 0.0, "bridged_gap must not be negative");
  require(options.carries_on >= 0.0, "carries_on must not be negative");
}

void StripeFinder::find(const LevelMask& mask, const std::vector<BorderPoint>& points,
                        const std::optional<StripePrior>& prior, std::vector<Stripe>& stripes) {
  mask_ = &mask;
  stripes_ = &stripes;
  stripes.clear();
  border_.assign(points);
  search(prior);
  if (drop_wear(
          *stripes_)) {  // it may have misled what was found after it, and has taken points of what was not
    border_.assign(points);
    for (const Stripe& stripe : *stripes_) spend_points_of(stripe);
    search(prior);
    drop_wear(*stripes_);
  }
  rank(*stripes_, prior, options_.carries_on);
}

void StripeFinder::search(const std::optional<StripePrior>& prior) {
  search_pairs();
  border_.release_deferred();
  search_single_borders(prior);
  search_side_paint();
}

void StripeFinder::search_pairs() {
  for (int round = 0; round < kRounds && std::ssize(*stripes_) < options_.max_stripes; ++round) {
    const auto peak = border_.strongest_direction();
    if (!peak || peak->length < options_.min_border_length) return;
    if (!take_pair(peak->theta_rad)) defer_direction(peak->theta_rad);
  }
}

void StripeFinder::search_single_borders(const std::optional<StripePrior>& prior) {
  for (int round = 0; round < kRounds && std::ssize(*stripes_) < options_.max_stripes; ++round) {
    const auto peak = border_.strongest_direction();
    if (!peak || peak->length < options_.min_border_length) return;
    if (!take_single_border(peak->theta_rad, known_width(prior))) defer_direction(peak->theta_rad);
  }
}

// Of the stripe with the most border, which is the surest. Paint that is whole has borders that tell its
// arms.
void StripeFinder::search_side_paint() {
  if (stripes_->empty() || !stripes_->front().both_borders) return;
  const Stripe stripe = stripes_->front();
  const double half = 0.5 * stripe.course.width;  // at a bend a stripe is half bare where it ends
  if (fill(stripe.course, {stripe.begin.along + half, stripe.end.along - half}) > kWhole) return;
  for (const SidePaint& paint :
       side_paint(*mask_, stripe, [this](const Eigen::Vector2d& p_L) { return is_on_stripe(p_L); }))
    if (std::ssize(*stripes_) < options_.max_stripes) take_arm(stripe, paint);
}

// Square to the stripe and of its width, unless what there is of its borders says it better.
void StripeFinder::take_arm(const Stripe& stripe, const SidePaint& paint) {
  const StripeAxes axes(stripe.course);
  // n(θ + π/2) = −forward(θ)
  const StripeCourse start =
      canonical({stripe.course.theta_rad + kPi / 2.0, -paint.along, stripe.course.width});
  StripeFit fit{.course = start};
  fit.covariance = Eigen::Vector2d(kArmSigma * kArmSigma, kArmSigma_rad * kArmSigma_rad).asDiagonal();
  const auto fitted = fit_stripe(border_.near(start.theta_rad), start, WidthIs::known);
  const bool agrees = fitted && axis_difference(fitted->course.theta_rad, start.theta_rad) < kArmTurn_rad;
  if (agrees) fit = *fitted;
  const Eigen::Vector2d inside = axes.at(paint.along, paint.side * paint.away);
  const Stripe arm = measured(fit, false, StripeAxes(fit.course).along(inside));
  if (is_paint_of(*stripes_, arm) || arm.end.along - arm.begin.along < kLeastArm) return;
  stripes_->push_back(arm);
  spend_points_of(arm);
}

bool StripeFinder::take_pair(double theta_rad) {
  const OffsetVotes votes(border_, theta_rad);
  const std::vector<OffsetPeak> falling = votes.peaks(false, kPeakLength);
  if (falling.empty()) return false;
  candidates_.clear();
  for (const OffsetPeak& near : votes.peaks(true, kPeakLength)) {
    for (const OffsetPeak& far : falling) {
      const double width = far.rho - near.rho, length = near.length + far.length;
      if (width < options_.min_width || width > options_.max_width) continue;
      if (length < options_.min_border_length) continue;  // of free points; accept() looks at all of them
      const StripeCourse course{theta_rad, 0.5 * (near.rho + far.rho), width};
      const double painted = fill(course, support(course));
      if (painted >= options_.min_fill) candidates_.push_back({course, length * (0.7 + 0.3 * painted)});
    }
  }
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return std::any_of(candidates_.begin(), candidates_.end(), [this](const Candidate& candidate) {
    return accept(candidate.course, WidthIs::free, true, 0.0);
  });
}

bool StripeFinder::take_single_border(double theta_rad, double known_width) {
  const OffsetVotes votes(border_, theta_rad);
  const double needed =
      known_width > 0.0 ? std::max(options_.min_border_length, 0.3 * known_width) : kUnhinted;
  for (const bool rising : {true, false}) {
    const double side = rising ? 1.0 : -1.0;
    for (const OffsetPeak& peak : votes.peaks(rising, needed)) {
      const StripeCourse border{theta_rad, peak.rho, 0.0};
      const double width = known_width > 0.0 ? known_width : depth_in_view(border, side);
      if (width < options_.min_width || width > options_.max_width) continue;
      const StripeCourse course{theta_rad, peak.rho + 0.5 * side * width, width};
      if (!only_one_border_in_view(course, side)) continue;
      if (fill(course, support(course)) < options_.min_fill) continue;
      if (!accept(course, WidthIs::known, false, side)) continue;
      if (known_width > 0.0) return true;
      Stripe& guess = stripes_->back();
      guess.feature.quality *= kGuessQuality;
      guess.feature.covariance(0, 0) += 0.25 * width * width;
      return true;
    }
  }
  return false;
}

bool StripeFinder::accept(const StripeCourse& start, WidthIs width, bool both_borders, double side) {
  auto fit = fit_stripe(border_.near(start.theta_rad), start, width);
  if (!fit) return false;
  // A glimpse of the other border beats the width that was assumed.
  if (!both_borders && std::min(fit->rising_length, fit->falling_length) > kPeakLength)
    if (const auto freed = fit_stripe(border_.near(fit->course.theta_rad), fit->course, WidthIs::free))
      fit = freed;
  const double length = fit->rising_length + fit->falling_length;
  const double per_width = both_borders ? options_.min_border_widths : 0.3;
  if (length < std::max(options_.min_border_length, per_width * fit->course.width)) return false;
  const Support range = support(fit->course);
  if (both_borders ? !has_border(fit->course, range, +1.0) || !has_border(fit->course, range, -1.0)
                   : !has_border(fit->course, range, -side))
    return false;
  const Stripe stripe = measured(*fit, both_borders, range.middle());
  if (!is_acceptable(stripe) || is_paint_of(*stripes_, stripe)) return false;
  stripes_->push_back(stripe);
  spend_points_of(stripe);
  return true;
}

// A stripe is longer than it is wide, unless the view cuts it at both ends.
bool StripeFinder::is_acceptable(const Stripe& stripe) const {
  if (stripe.feature.quality < options_.min_quality) return false;
  if (stripe.begin.leaves_view && stripe.end.leaves_view) return true;
  return stripe.end.along - stripe.begin.along >= 1.1 * stripe.course.width;
}

bool StripeFinder::has_border(const StripeCourse& course, const Support& range, double side) {
  const auto is_known = [this](const Eigen::Vector2d& p_L) { return is_on_stripe(p_L); };
  const BorderCount count = border_check_.count(*mask_, course, {range.from, range.to, side}, is_known);
  return stripes_->empty() ? count.is_border_of_first() : count.is_border();
}

bool StripeFinder::is_on_stripe(const Eigen::Vector2d& p_L) const {
  return std::any_of(stripes_->begin(), stripes_->end(), [&p_L](const Stripe& stripe) {
    const StripeAxes axes(stripe.course);
    const double along = axes.along(p_L);
    return std::abs(axes.across(p_L)) < 0.5 * stripe.course.width + kBeside &&
           along > stripe.begin.along - kBeside && along < stripe.end.along + kBeside;
  });
}

bool StripeFinder::only_one_border_in_view(const StripeCourse& course, double side) const {
  const Support range = support(course);
  const StripeAxes axes(course);
  constexpr int samples = 12;
  int seen = 0;
  for (int k = 0; k < samples; ++k) {
    const double along = range.from + (range.to - range.from) * (k + 0.5) / samples;
    const Eigen::Vector2d beyond = axes.at(along, side * (0.5 * course.width + kNear));
    seen += int{mask_->at(beyond) != Paint::out_of_view};
  }
  return 2 * seen < samples;
}

// Without branches, as all loops over the points: worn paint would mispredict every other one.
void StripeFinder::spend_points_of(const Stripe& stripe) {
  const StripeAxes axes(stripe.course);
  const double half = 0.5 * stripe.course.width;
  for (std::size_t i = 0; i < border_.size(); ++i) {
    const BorderPoint& point = border_.at(i);
    const double across = std::abs(axes.across(point.p_L)), along = axes.along(point.p_L);
    const bool beside = (along > stripe.begin.along - kBesideEnd) & (along < stripe.end.along + kBesideEnd);
    const bool inside = (across < half + 0.5 * kOwn) & beside;
    const bool faces = std::abs(point.normal.dot(axes.normal())) > kFacing;
    const bool own = (std::abs(across - half) < kOwn) & faces;
    border_.spend_if(i, inside | own);
  }
}

void StripeFinder::defer_direction(double theta_rad) {
  const auto tried = [theta_rad](double point_theta_rad) {  // both in [−π/2, π/2]
    const double apart_rad = std::abs(point_theta_rad - theta_rad);
    return std::min(apart_rad, kPi - apart_rad) < kTried_rad;
  };
  for (const BorderPoint& point : border_.near(theta_rad, kTried_rad)) {
    const std::size_t i = border_.number(point);
    const bool defers = (border_.use(i) == PointUse::free) & tried(point.theta_rad);
    border_.set_use(i, defers ? PointUse::deferred : border_.use(i));
  }
}

StripeFinder::Support StripeFinder::support(const StripeCourse& course) const {
  const StripeAxes axes(course);
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  constexpr double beyond[2] = {kNowhere, 0.0};  // puts what does not support the course out of the way
  Support range{.from = kNowhere, .to = -kNowhere};
  for (const BorderPoint& point : border_.near(course.theta_rad, kFacing_rad)) {
    const bool is_near = std::abs(border_residual(point, course, axes.normal())) <= kNear;
    const bool supports = is_near & (std::abs(point.normal.dot(axes.normal())) >= kFacing);
    const double along = axes.along(point.p_L);
    range.from = std::min(range.from, along + beyond[supports]);
    range.to = std::max(range.to, along - beyond[supports]);
  }
  if (range.from > range.to) range = {};
  return range;
}

double StripeFinder::fill(const StripeCourse& course, const Support& support) const {
  constexpr int sections = 16;
  const StripeAxes axes(course);
  int seen = 0, painted = 0;
  for (int k = 0; k < sections; ++k) {
    const double along = support.from + (support.to - support.from) * (k + 0.5) / sections;
    const CrossSection section = cross_section(*mask_, axes, along);
    seen += section.in_view;
    painted += section.painted;
  }
  return seen == 0 ? 0.0 : static_cast<double>(painted) / seen;
}

double StripeFinder::depth_in_view(const StripeCourse& border, double side) const {
  const StripeAxes axes(border);
  const double along = support(border).middle();
  double depth = 0.0;
  while (depth < options_.max_width && mask_->at(axes.at(along, side * (depth + kOwn))) == Paint::painted)
    depth += kOwn;
  return depth;
}

double StripeFinder::known_width(const std::optional<StripePrior>& prior) const {
  if (!stripes_->empty()) return stripes_->front().course.width;
  return prior ? prior->width : 0.0;
}

Stripe StripeFinder::measured(const StripeFit& fit, bool both_borders, double middle) const {
  Stripe stripe{.course = fit.course, .feature = {}, .begin = {}, .end = {}, .both_borders = both_borders};
  const StripeAxes axes(fit.course);
  stripe.end = follow_paint(*mask_, axes, middle, +1, options_.bridged_gap);
  stripe.begin = follow_paint(*mask_, axes, middle, -1, options_.bridged_gap);
  const double visible = border_in_view(*mask_, axes, stripe.begin.along, stripe.end.along);
  LineFeature& feature = stripe.feature;
  feature.rho = fit.course.rho;
  feature.theta_rad = fit.course.theta_rad;
  feature.covariance = fit.covariance;
  feature.width = fit.course.width;
  feature.quality = std::min(1.0, (fit.rising_length + fit.falling_length) / std::max(visible, 1e-9));
  const auto point = [&](double along) {
    const Eigen::Vector2d p = axes.at(along, 0.0);
    return LevelPoint{p.x(), p.y()};
  };
  feature.begin = point(stripe.begin.along);
  feature.end = point(stripe.end.along);
  return stripe;
}

}  // namespace lineservo::features
