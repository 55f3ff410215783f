#pragma once

#include <cstddef>
#include <vector>

namespace lineservo::apps {

/// A confidence interval, both ends included.
struct Interval {
  double low, high;
};

/// Wilson's 95 % score interval of a rate; NaN without a trial.
Interval wilson95(long successes, long trials);

/// The mean of the values that are numbers; NaN where there are none.
double mean_of(const std::vector<double>& values);

/// The mean of paired differences with the 95 % percentile interval of 2000 bootstrap resamples of whole
/// pairs. The resamples come from a seed of their own: the same differences give the same interval. NaN
/// without a pair; one pair has no interval.
struct PairedDifference {
  double mean;
  Interval ci95;
  std::size_t pairs;
};
PairedDifference paired_difference(const std::vector<double>& differences);

}  // namespace lineservo::apps
