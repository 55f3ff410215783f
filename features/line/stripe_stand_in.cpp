#include "features/line/stripe_stand_in.h"

#include <algorithm>
#include <cmath>

#include "features/geometry/angles.h"

namespace lineservo::features {
namespace {

constexpr double kAlong_rad = radians(10.0);
constexpr double kBeside = 0.05;  // of a stripe's border, normalised units

// Both in direction and where the stripe is in view: on it or on its border.
bool runs_along(const LineFeature& line, const LineFeature& stripe) {
  if (axis_difference(line.theta_rad, stripe.theta_rad) > kAlong_rad) return false;
  const Eigen::Vector2d middle = 0.5 * (stripe.begin.vector() + stripe.end.vector());
  const Eigen::Vector2d normal(std::cos(line.theta_rad), std::sin(line.theta_rad));
  return std::abs(middle.dot(normal) - line.rho) < 0.5 * stripe.width + kBeside;
}

std::vector<LineFeature> as_told(const std::vector<LineFeature>& told, std::vector<LineFeature> stripes) {
  for (LineFeature& stripe : stripes) {
    const auto line =
        std::find_if(told.begin(), told.end(), [&](const LineFeature& l) { return runs_along(l, stripe); });
    if (line != told.end()) stripe = *line;
  }
  return stripes;
}

std::vector<LineFeature> told_first(std::vector<LineFeature> told, const std::vector<LineFeature>& stripes) {
  const std::size_t lines = told.size();
  std::copy_if(stripes.begin(), stripes.end(), std::back_inserter(told), [&](const LineFeature& stripe) {
    return std::none_of(told.begin(), told.begin() + static_cast<std::ptrdiff_t>(lines),
                        [&](const LineFeature& line) { return runs_along(line, stripe); });
  });
  return told;
}

}  // namespace

std::vector<LineFeature> with_stripes(const std::vector<LineFeature>& told,
                                      const std::vector<LineFeature>& stripes, LinesMeet meet) {
  if (meet == LinesMeet::yes) return as_told(told, stripes);
  return told.empty() ? told : told_first(told, stripes);
}

}  // namespace lineservo::features
