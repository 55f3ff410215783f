#include "apps/evaluate/line_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "apps/scoring/percentile.h"
#include "features/geometry/angles.h"

namespace lineservo::apps {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double share(int part, int whole) {
  return whole == 0 ? kNone : static_cast<double>(part) / whole;
}

}  // namespace

ErrorSummary summarise_errors(std::vector<double> sizes) {
  if (sizes.empty()) return {kNone, kNone, kNone};
  std::sort(sizes.begin(), sizes.end());
  const double sum = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  return {sum / static_cast<double>(sizes.size()), ranked(sizes, 0.5), ranked(sizes, 0.95)};
}

// With p = hits/n: (p + z²/2n ± z √(p(1−p)/n + z²/4n²)) / (1 + z²/n).
ShareInterval wilson_interval(int hits, int trials) {
  if (trials == 0) return {kNone, kNone};
  constexpr double z = 1.959964;
  const double n = trials, p = hits / n, scale = 1.0 / (1.0 + z * z / n);
  const double middle = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, scale * (middle - half)), std::min(1.0, scale * (middle + half))};
}

double LineScore::detection_rate() const {
  return share(found, frames_with_line);
}

double LineScore::false_alarm_rate() const {
  return share(false_alarms, frames_without_line);
}

void LineScore::add(const std::optional<features::ImageLine>& truth,
                    const std::optional<features::ImageLine>& answer) {
  if (!truth) {
    ++frames_without_line;
    false_alarms += int{answer.has_value()};
    return;
  }
  ++frames_with_line;
  if (!answer) return;
  ++answered;
  const features::LineDifference d = difference(*answer, *truth);
  rho_px.push_back(std::abs(d.rho_px));
  theta_deg.push_back(std::abs(features::degrees(d.theta_rad)));
  found += int{rho_px.back() <= kFoundWithin_px && theta_deg.back() <= kFoundWithin_deg};
}

}  // namespace lineservo::apps
