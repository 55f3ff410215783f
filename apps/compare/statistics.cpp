#include "apps/compare/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "apps/scoring/percentile.h"
#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kNormal975 = 1.959963984540054;  // quantile of the standard normal
constexpr int kResamples = 2000;
constexpr std::uint64_t kBootstrapSeed = 20250;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double resampled_mean(const std::vector<double>& values, vehicle::Random& random) {
  const double n = static_cast<double>(values.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += values[static_cast<std::size_t>(random.uniform() * n)];  // uniform() < 1
  return sum / n;
}

}  // namespace

// (p̂ + z²/2n ± z √(p̂(1−p̂)/n + z²/4n²)) / (1 + z²/n)   (Wilson 1927)
Interval wilson95(long successes, long trials) {
  if (trials == 0) return {kNaN, kNaN};
  const double n = static_cast<double>(trials), p = static_cast<double>(successes) / n;
  const double z2_n = kNormal975 * kNormal975 / n;
  const double centre = p + z2_n / 2.0;
  const double half = kNormal975 * std::sqrt(p * (1.0 - p) / n + z2_n / (4.0 * n));
  const double low = successes == 0 ? 0.0 : (centre - half) / (1.0 + z2_n);
  const double high = successes == trials ? 1.0 : (centre + half) / (1.0 + z2_n);
  return {low, high};
}

double mean_of(const std::vector<double>& values) {
  std::vector<double> numbers;
  std::copy_if(values.begin(), values.end(), std::back_inserter(numbers),
               [](double v) { return std::isfinite(v); });
  return numbers.empty() ? kNaN : mean(numbers);
}

PairedDifference paired_difference(const std::vector<double>& differences) {
  if (differences.empty()) return {kNaN, {kNaN, kNaN}, 0};
  if (differences.size() == 1) return {differences.front(), {kNaN, kNaN}, 1};
  vehicle::Random random(kBootstrapSeed);
  std::vector<double> means(kResamples);
  for (double& m : means) m = resampled_mean(differences, random);
  std::sort(means.begin(), means.end());
  return {mean(differences), {ranked(means, 0.025), ranked(means, 0.975)}, differences.size()};
}

}  // namespace lineservo::apps
