#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/output/flight_summary.h"

namespace lineservo::apps {

// How a law's tuned parameters are found: apps/compare/tuning.md.

/// A parameter that the search may change, within bounds.
struct TunableParameter {
  std::string key;
  double published, low, high;
};

/// Those of a controller. Throws std::invalid_argument for an unknown one.
std::vector<TunableParameter> tunable_parameters(const std::string& controller);

/// What a flight costs; lower is better.
double flight_cost(const FlightSummary& summary);

/// One point of the search.
struct TuningTrial {
  std::vector<double> values;  ///< of the parameters, in their order
  double cost = 0.0;           ///< mean over the training flights
  int failed = 0;              ///< of them
};

/// What a search tried, in its order.
struct TuningResult {
  std::string controller;
  std::vector<TunableParameter> parameters;
  std::vector<TuningTrial> trials;  ///< the published values first

  const TuningTrial& published() const { return trials.front(); }
  const TuningTrial& best() const;  ///< the first of the cheapest
};

/// How long and on how many threads parameters are searched.
struct TuningOptions {
  int budget = 60;  ///< points, each flown by all training flights
  int jobs = 1;     ///< the result is the same for any number
};

/// None when `watch`, told how many points are done, returned false.
std::optional<TuningResult> tune(const std::string& controller, const TuningOptions& options,
                                 const std::function<bool(std::size_t done)>& watch);

/// The best values as a file of tuned parameters.
std::string tuned_yaml(const TuningResult& result);

}  // namespace lineservo::apps
