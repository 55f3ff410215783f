#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/comparison.h"
#include "apps/compare/statistics.h"

namespace lineservo::apps {

/// A figure of one flight; NaN where it does not apply (apps/results.md says to which flights each does).
struct Metric {
  std::string_view name;
  double (*of)(const FlightSummary&);
};
const std::vector<Metric>& metrics();

/// A figure of a flight by the metric's name; the name must be one.
double figure(std::string_view metric, const FlightSummary& summary);

/// What the flights of one contestant come to.
struct Standing {
  long runs = 0, arrived = 0;
  long tracked = 0;  ///< flights in which a leg was begun: those of the tracking figures
  std::map<std::string, long> outcomes;
  Interval success_ci95{};
  std::map<std::string, double, std::less<>> means;  ///< of every metric
  double max_m = 0.0, hold_max_m = 0.0;              ///< the largest of any flight
  double junction_accuracy = 0.0;                    ///< raw, of all frames
  ErrorDistribution distribution{};
  double perception_ms = 0.0, control_ms = 0.0;

  double success_rate() const { return static_cast<double>(arrived) / static_cast<double>(runs); }
  double mean(std::string_view metric) const { return means.find(metric)->second; }
};
Standing standing_of(const Contestant& contestant);

/// The mean difference a − b of a metric over the flights that both flew, pair by pair.
struct Pair {
  const Entry* a;
  const Entry* b;
  std::string_view metric;
  PairedDifference difference;
};
/// Every contestant against the reference in its group: as published against as published, tuned against
/// tuned where the reference flies tuned, too.
std::vector<Pair> pairs_of(const std::vector<Contestant>& contestants, const std::string& reference);

}  // namespace lineservo::apps
