#include "features/junction/stripe_junction.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "features/geometry/angles.h"
#include "features/junction/narrower_arm.h"
#include "features/line/stripe_extent.h"

namespace lineservo::features {
namespace {

constexpr double kStep = 0.03;        // along an arm
constexpr double kAskew = 0.906;      // sine of the angle: more than 25° off square
constexpr double kNodeMargin = 0.01;  // paint of the other stripe may reach so far past its border

void require(bool holds, const char* fault) {
  if (!holds) throw std::invalid_argument(std::string("junction options: ") + fault);
}

// Both centrelines hold at the centre: N c = ρ with the normals as rows. An error (dρ, dθ) of one moves it by
// dρ − t dθ along its normal, t = c·n'(θ); the centre's covariance is N⁻¹ diag(σ²) N⁻ᵀ.
Eigen::Matrix2d centre_covariance(const Eigen::Vector2d& centre, const Eigen::Matrix2d& normals_inverse,
                                  const Stripe& a, const Stripe& b) {
  const auto variance = [&centre](const Stripe& stripe) {
    const Eigen::Vector2d g(1.0, centre.dot(stripe.course.forward()));
    return g.dot(stripe.feature.covariance * g);
  };
  const Eigen::Vector2d variances(variance(a), variance(b));
  return normals_inverse * variances.asDiagonal() * normals_inverse.transpose();
}

// Inside the other stripe the paint may be the other's; past it, it is the arm's own. Stripes that meet askew
// are rounded off by half of the broader one's width, which is no arm either.
double node_half_length(double own_width, double other_width, double sine) {
  const double across = 0.5 * other_width / sine;
  const bool is_askew = sine < kAskew;
  return (is_askew ? std::max(across, 0.5 * own_width) : across) + kNodeMargin;
}

// The other stripe may go on broader past the node than it was measured: its paint beside this stripe, to the
// side where the arm would be.
double broad_half(const LevelMask& mask, const Stripe& stripe, const Stripe& other, LevelPoint centre,
                  int way) {
  constexpr double kBeside = 0.04, kFarthest = 0.6, kBroader = 0.03;
  const StripeAxes axes(other.course);
  const double side = way * stripe.course.forward().dot(axes.normal()) > 0.0 ? 1.0 : -1.0;
  const double beside = 0.5 * stripe.course.width + kBeside;
  double half = 0.0;
  for (const double along : {-beside, beside}) {
    const double at = axes.along(centre.vector()) + along;
    half = std::max(half, painted_to(mask, axes, at, side, kFarthest).value_or(0.0));
  }
  return half > 0.5 * other.course.width + kBroader ? half + kNodeMargin : 0.0;
}

JunctionArm arm_to(const StripeCourse& course, const StripeEnd& end, double width, double centre_along,
                   int way) {
  const Eigen::Vector2d along = way * course.forward();
  JunctionArm arm;
  arm.feature.angle_rad = std::atan2(-along.x(), -along.y());
  arm.feature.length = std::max(0.0, std::abs(end.along - centre_along) - 0.5 * width);
  arm.width = width;
  arm.leaves_view = end.leaves_view;
  return arm;
}

double distance_from_image_centre_px(const LevelMask& mask, const LevelPoint& centre) {
  const PixelPoint px = mask.project(centre.vector());
  return std::hypot(px.x - 0.5 * (mask.mask().width - 1), px.y - 0.5 * (mask.mask().height - 1));
}

}  // namespace

JunctionFinder::JunctionFinder(const JunctionOptions& options) : options_(options) {
  require(options.min_angle_rad > 0.0 && options.min_angle_rad < kPi / 2.0,
          "min_angle_rad must be in (0, π/2)");
  require(options.min_painted > 0.0 && options.min_painted <= 1.0, "min_painted must be in (0, 1]");
  require(options.min_seen > 0.0, "min_seen must be positive");
  require(options.max_gap >= 0.0, "max_gap must not be negative");
}

std::optional<StripeJunction> JunctionFinder::find(const LevelMask& mask,
                                                   const std::vector<Stripe>& stripes) const {
  std::optional<StripeJunction> nearest;
  std::size_t a = 0, b = 0;
  double nearest_px = 0.0;
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    for (std::size_t j = i + 1; j < stripes.size(); ++j) {
      auto junction = meeting(mask, stripes[i], stripes[j]);
      if (!junction) continue;
      const double px = distance_from_image_centre_px(mask, junction->feature.centre);
      if (nearest && px >= nearest_px) continue;
      nearest = std::move(junction);
      nearest_px = px;
      a = i;
      b = j;
    }
  }
  if (nearest) add_others(mask, stripes, a, b, *nearest);
  return nearest;
}

// At a fork more than two stripes meet.
void JunctionFinder::add_others(const LevelMask& mask, const std::vector<Stripe>& stripes, std::size_t a,
                                std::size_t b, StripeJunction& junction) const {
  const Eigen::Vector2d centre = junction.feature.centre.vector();
  for (std::size_t k = 0; k < stripes.size(); ++k) {
    const StripeCourse& course = stripes[k].course;
    if (k == a || k == b || std::abs(course.normal().dot(centre) - course.rho) > options_.max_off) continue;
    double half_node = 0.0, least_sine = 1.0;
    for (const StripeCourse* other : {&stripes[a].course, &stripes[b].course}) {
      const double sine = std::abs(std::sin(course.theta_rad - other->theta_rad));
      least_sine = std::min(least_sine, sine);
      half_node = std::max(half_node, node_half_length(course.width, other->width, sine));
    }
    if (least_sine < std::sin(options_.min_angle_rad)) continue;
    const std::size_t known = junction.arms.size();
    add_arms(mask, stripes[k], nullptr, half_node, junction);
    for (std::size_t i = known; i < junction.arms.size(); ++i)
      junction.feature.arms.push_back(junction.arms[i].feature);
  }
}

std::optional<StripeJunction> JunctionFinder::meeting(const LevelMask& mask, const Stripe& a,
                                                      const Stripe& b) const {
  Eigen::Matrix2d normals;
  normals << a.course.normal().transpose(), b.course.normal().transpose();
  const double sine = std::abs(normals.determinant());
  if (sine < std::sin(options_.min_angle_rad)) return std::nullopt;
  const Eigen::Matrix2d inverse = normals.inverse();
  const Eigen::Vector2d centre = inverse * Eigen::Vector2d(a.course.rho, b.course.rho);

  StripeJunction junction;
  junction.feature.centre = {centre.x(), centre.y()};
  junction.feature.covariance = centre_covariance(centre, inverse, a, b);
  junction.feature.quality = std::min(a.feature.quality, b.feature.quality);
  const bool is_square = sine >= kAskew;
  const int arms_a = add_arms(mask, a, is_square ? &b : nullptr,
                              node_half_length(a.course.width, b.course.width, sine), junction);
  const int arms_b = add_arms(mask, b, is_square ? &a : nullptr,
                              node_half_length(b.course.width, a.course.width, sine), junction);
  if (arms_a == 0 || arms_b == 0) return std::nullopt;
  for (const JunctionArm& arm : junction.arms) junction.feature.arms.push_back(arm.feature);
  return junction;
}

int JunctionFinder::add_arms(const LevelMask& mask, const Stripe& stripe, const Stripe* other,
                             double half_node, StripeJunction& junction) const {
  const StripeAxes axes(stripe.course);
  const double centre_along = axes.along(junction.feature.centre.vector());
  int found = 0;
  for (const int way : {+1, -1}) {
    const double broad = other ? broad_half(mask, stripe, *other, junction.feature.centre, way) : 0.0;
    const auto seen = arm(mask, stripe, axes, centre_along, way, std::max(half_node, broad));
    if (!seen) continue;
    junction.arms.push_back(*seen);
    ++found;
  }
  return found;
}

std::optional<JunctionArm> JunctionFinder::arm(const LevelMask& mask, const Stripe& stripe,
                                               const StripeAxes& axes, double centre_along, int way,
                                               double half_node) const {
  const StripeEnd& end = way > 0 ? stripe.end : stripe.begin;
  const StripeEnd& start = way > 0 ? stripe.begin : stripe.end;
  const double from = centre_along + way * half_node;
  const double reach = way * (end.along - from);
  if (reach < options_.min_seen) return narrower(mask, stripe, from, centre_along, way);
  if (way * (start.along - from) > options_.max_gap) return std::nullopt;
  int seen = 0, in_view = 0, painted = 0;
  for (double gone = 0.5 * kStep; gone < reach; gone += kStep) {
    const CrossSection section = cross_section(mask, axes, from + way * gone);
    seen += int{!section.is_out_of_view()};
    in_view += section.in_view;
    painted += section.painted;
  }
  if (seen * kStep < 0.5 * options_.min_seen || painted < options_.min_painted * in_view) return std::nullopt;
  return arm_to(stripe.course, end, stripe.course.width, centre_along, way);
}

// The way may go on narrower past the node than it came.
std::optional<JunctionArm> JunctionFinder::narrower(const LevelMask& mask, const Stripe& stripe, double from,
                                                    double centre_along, int way) const {
  const auto seen = narrower_arm(mask, stripe.course, from, way);
  if (!seen || way * (seen->end.along - from) < options_.min_narrower) return std::nullopt;
  return arm_to(stripe.course, seen->end, seen->width, centre_along, way);
}

}  // namespace lineservo::features
