#pragma once

#include <vector>

namespace lineservo::apps {

/// The value that a share of the sorted values does not exceed (nearest rank); NaN where there are none.
double ranked(const std::vector<double>& sorted, double share);

/// The same of values in any order.
double percentile(std::vector<double> values, double share);

}  // namespace lineservo::apps
