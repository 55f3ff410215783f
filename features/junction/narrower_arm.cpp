#include "features/junction/narrower_arm.h"

#include <array>
#include <cmath>

#include "features/line/stripe_extent.h"

namespace lineservo::features {
namespace {

constexpr double kStep = 0.005;       // one mask pixel
constexpr double kLeastWidth = 0.02;  // four mask pixels
constexpr double kMostShare = 0.85;   // of the stripe's width: wider it is the stripe itself
constexpr double kSameShare = 0.4;    // by which the widths at two places may differ
constexpr double kBridged = 0.1;      // worn paint

struct Run {
  double width, middle;
};

std::optional<Run> run_at(const LevelMask& mask, const StripeAxes& axes, double along) {
  const auto right = painted_to(mask, axes, along, 1.0, axes.width());
  const auto left = painted_to(mask, axes, along, -1.0, axes.width());
  if (!right || !left) return std::nullopt;
  const Run run{*right + *left, 0.5 * (*right - *left)};
  const bool is_narrower = run.width >= kLeastWidth && run.width <= kMostShare * axes.width();
  return is_narrower ? std::optional(run) : std::nullopt;
}

}  // namespace

std::optional<double> painted_to(const LevelMask& mask, const StripeAxes& axes, double along, double side,
                                 double bound) {
  double across = 0.0;
  for (; across <= bound; across += kStep) {
    const Paint paint = mask.at(axes.at(along, side * across));
    if (paint == Paint::out_of_view) return std::nullopt;
    if (paint != Paint::painted) break;
  }
  return across;
}

std::optional<NarrowerArm> narrower_arm(const LevelMask& mask, const StripeCourse& course, double from,
                                        int way) {
  const StripeAxes axes(course);
  const double near = from + way * 0.015, far = from + way * 0.035;
  const auto first = run_at(mask, axes, near), second = run_at(mask, axes, far);
  if (!first || !second) return std::nullopt;
  const double width = 0.5 * (first->width + second->width);
  if (std::abs(first->width - second->width) > kSameShare * width) return std::nullopt;
  const StripeCourse narrow{course.theta_rad, course.rho + 0.5 * (first->middle + second->middle), width};
  return NarrowerArm{width, follow_paint(mask, StripeAxes(narrow), near, way, kBridged)};
}

}  // namespace lineservo::features
