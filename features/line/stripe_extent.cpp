#include "features/line/stripe_extent.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kStep = 0.02;     // along the stripe: 4 mask pixels
constexpr double kInset = 0.015;   // of the outer samples from the border: 3 mask pixels
constexpr double kBroad = 0.2;     // blotches of worn paint are narrower than this
constexpr double kLongest = 4.0;   // no view reaches further
constexpr double kLastGap = 0.06;  // bare floor of this length before the edge of the image ends a stripe

void sample(const LevelMask& mask, const Eigen::Vector2d& p_L, CrossSection& section) {
  const Paint paint = mask.at(p_L);
  section.in_view += int{paint != Paint::out_of_view};
  section.painted += int{paint == Paint::painted};
}

}  // namespace

CrossSection cross_section(const LevelMask& mask, const StripeAxes& axes, double along) {
  CrossSection section;
  const double inner = 0.3 * axes.width();
  for (const double across : {-inner, 0.0, inner}) sample(mask, axes.at(along, across), section);
  if (axes.width() > kBroad)
    for (const double share : {-0.4, -0.15, 0.15, 0.4})
      sample(mask, axes.at(along, share * axes.width()), section);
  else if (section.in_view == 3)
    return section;
  if (section.in_view == 7) return section;
  const double outer = std::max(0.5 * axes.width() - kInset, 0.25 * axes.width());
  for (const double across : {-outer, outer}) sample(mask, axes.at(along, across), section);
  return section;
}

StripeEnd follow_paint(const LevelMask& mask, const StripeAxes& axes, double along, int way, double bridged) {
  StripeEnd end{.along = along, .leaves_view = false, .bare = 0.0};
  for (double gone = 0.0; gone < kLongest; gone += kStep) {
    const double here = along + way * gone;
    const CrossSection section = cross_section(mask, axes, here);
    if (section.is_out_of_view()) {
      end.leaves_view = end.bare < kLastGap;
      break;
    }
    if (section.is_painted()) {
      end.along = here;
      end.bare = 0.0;
    } else if ((end.bare += kStep) > bridged) {
      break;
    }
  }
  return end;
}

bool paint_bends_away(const LevelMask& mask, const StripeCourse& course, double end_along) {
  constexpr double kLeastRadius = 0.15;
  constexpr int kSteps = 5;  // of 15° to either side
  const StripeAxes axes(course);
  const double radius = std::max(course.width, kLeastRadius);
  for (int k = -kSteps; k <= kSteps; ++k) {
    const double angle_rad = radians(15.0 * k);
    const Eigen::Vector2d p = axes.at(end_along + radius * std::cos(angle_rad), radius * std::sin(angle_rad));
    if (mask.at(p) == Paint::painted) return true;
  }
  return false;
}

double border_in_view(const LevelMask& mask, const StripeAxes& axes, double from, double to) {
  constexpr double step = 2.0 * kStep;
  int seen = 0;
  for (double along = from; along <= to; along += step)
    for (const double side : {-0.5, 0.5})
      seen += int{mask.at(axes.at(along, side * axes.width())) != Paint::out_of_view};
  return seen * step;
}

}  // namespace lineservo::features
