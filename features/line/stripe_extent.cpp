#include "features/line/stripe_extent.h"

#include <algorithm>
#include <array>

namespace lineservo::features {
namespace {

constexpr double kStep = 0.02;     // along the stripe: 4 mask pixels
constexpr double kInset = 0.015;   // of the outer samples from the border: 3 mask pixels
constexpr double kLongest = 4.0;   // no view reaches further
constexpr double kLastGap = 0.06;  // bare floor of this length before the edge of the image ends a stripe

std::array<double, 5> across_samples(double width) {
  const double outer = std::max(0.5 * width - kInset, 0.25 * width);
  return {-outer, -0.3 * width, 0.0, 0.3 * width, outer};
}

}  // namespace

CrossSection cross_section(const LevelMask& mask, const StripeCourse& course, double along) {
  CrossSection section;
  const Eigen::Vector2d centre = course.at(along, 0.0);
  const Eigen::Vector2d normal = course.normal();
  for (const double across : across_samples(course.width)) {
    const Paint paint = mask.at(centre + across * normal);
    section.in_view += int{paint != Paint::out_of_view};
    section.painted += int{paint == Paint::painted};
  }
  return section;
}

StripeEnd follow_paint(const LevelMask& mask, const StripeCourse& course, double along, int way,
                       double bridged) {
  StripeEnd end{.along = along, .leaves_view = false, .bare = 0.0};
  for (double gone = 0.0; gone < kLongest; gone += kStep) {
    const double here = along + way * gone;
    const CrossSection section = cross_section(mask, course, here);
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

double border_in_view(const LevelMask& mask, const StripeCourse& course, double from, double to) {
  constexpr double step = 2.0 * kStep;
  int seen = 0;
  for (double along = from; along <= to; along += step)
    for (const double side : {-0.5, 0.5})
      seen += int{mask.at(course.at(along, side * course.width)) != Paint::out_of_view};
  return seen * step;
}

}  // namespace lineservo::features
