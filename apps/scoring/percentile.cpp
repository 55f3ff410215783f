#include "apps/scoring/percentile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lineservo::apps {

double ranked(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return ranked(values, share);
}

}  // namespace lineservo::apps
