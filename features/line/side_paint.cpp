#include "features/line/side_paint.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lineservo::features {
namespace {

constexpr double kStep = 0.03;     // along the stripe, or a fifth of its width
constexpr double kMargin = 0.04;   // of the first samples from the border
constexpr double kSpacing = 0.07;  // between samples away from the stripe
constexpr int kSamples = 5;
constexpr double kReach = kSamples * kSpacing;  // a disc on the node hides the nearer part of an arm
constexpr double kNearby = 0.12;                // beside an arm the floor is bare for so long
constexpr int kFewest = 10;                     // painted samples of an arm
constexpr double kArm = 0.45;                   // share of an arm that is painted, at least
constexpr double kFloor = 0.35;                 // and of the floor beside it, at most
constexpr double kBalance = 0.4;                // of painted and bare samples in the search of the best place

struct Count {
  int in_view = 0, painted = 0;

  double surplus() const { return painted - kBalance * in_view; }
  bool is_bare() const { return painted <= kFloor * in_view; }
};

/// Counts summed up along the stripe, so that those of any stretch are a difference.
class Profile {
 public:
  Profile(const LevelMask& mask, const Stripe& stripe, double side, double nearest,
          const std::function<bool(const Eigen::Vector2d&)>& is_known)
      : step_(std::min(kStep, 0.2 * stripe.course.width)), begin_(stripe.begin.along) {
    const StripeAxes axes(stripe.course);
    Count sum;
    sums_.push_back(sum);
    for (double along = begin_ + 0.5 * step_; along < stripe.end.along; along += step_) {
      for (int k = 0; k < kSamples; ++k) {
        const Eigen::Vector2d p_L = axes.at(along, side * (nearest + k * kSpacing));
        const Paint paint = mask.at(p_L);
        if (paint == Paint::out_of_view || (paint == Paint::painted && is_known(p_L))) continue;
        ++sum.in_view;
        sum.painted += int{paint == Paint::painted};
      }
      sums_.push_back(sum);
    }
  }

  Count between(double from, double to) const {
    const Count &a = at(from), &b = at(to);
    return {b.in_view - a.in_view, b.painted - a.painted};
  }
  Count whole() const { return sums_.back(); }
  double step() const { return step_; }

 private:
  const Count& at(double along) const {
    const long index = std::lround((along - begin_) / step_);
    return sums_[static_cast<std::size_t>(std::clamp<long>(index, 0, std::ssize(sums_) - 1))];
  }

  double step_, begin_;
  std::vector<Count> sums_;
};

std::optional<double> arm_along(const Profile& profile, const Stripe& stripe) {
  if (profile.whole().painted < kFewest) return std::nullopt;
  const double half = 0.5 * stripe.course.width;
  double best = 0.0, best_along = 0.0;
  for (double along = stripe.begin.along - half; along <= stripe.end.along + half; along += profile.step()) {
    const double surplus = profile.between(along - half, along + half).surplus();
    if (surplus > best) best = surplus, best_along = along;
  }
  const Count arm = profile.between(best_along - half, best_along + half);
  const Count before = profile.between(best_along - half - kNearby, best_along - half - profile.step());
  const Count after = profile.between(best_along + half + profile.step(), best_along + half + kNearby);
  const bool is_arm = arm.painted >= kFewest && arm.painted >= kArm * arm.in_view;
  if (!is_arm || !before.is_bare() || !after.is_bare()) return std::nullopt;
  return best_along;
}

}  // namespace

std::vector<SidePaint> side_paint(const LevelMask& mask, const Stripe& stripe,
                                  const std::function<bool(const Eigen::Vector2d&)>& is_known) {
  std::vector<SidePaint> found;
  for (const double side : {-1.0, 1.0})
    for (const double margin : {kMargin, kMargin + kReach}) {
      const double nearest = 0.5 * stripe.course.width + margin;
      const auto along = arm_along(Profile(mask, stripe, side, nearest, is_known), stripe);
      if (!along) continue;
      found.push_back({*along, side, nearest});
      break;
    }
  return found;
}

}  // namespace lineservo::features
