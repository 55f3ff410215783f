#include "apps/compare/metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace lineservo::apps {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double terminal_error_m(const FlightSummary& s) {
  return s.succeeded() && s.rest ? s.rest->target_error_m : kNaN;
}

/// NaN is passed over; NaN where there is no number.
double largest(const std::vector<double>& values) {
  double max = kNaN;
  for (const double v : values) max = std::fmax(max, v);
  return max;
}

std::vector<double> figures(std::string_view metric, const Contestant& c) {
  std::vector<double> values;
  for (const ComparedFlight& flight : c.flights) values.push_back(figure(metric, flight.summary));
  return values;
}

double junction_accuracy(const Contestant& c) {
  long frames = 0, wrong = 0;
  for (const ComparedFlight& flight : c.flights) {
    frames += flight.summary.junctions.frames;
    wrong += flight.summary.junctions.misclassified;
  }
  return frames == 0 ? kNaN : 1.0 - static_cast<double>(wrong) / static_cast<double>(frames);
}

double mean_ms(const Contestant& c, StageTiming FlightTiming::*stage) {
  StageTiming sum;
  for (const ComparedFlight& flight : c.flights) {
    sum.total_s += (flight.summary.timing.*stage).total_s;
    sum.calls += (flight.summary.timing.*stage).calls;
  }
  return sum.mean_ms();
}

void add(ErrorDistribution& sum, const ErrorDistribution& one) {
  std::transform(sum.begin(), sum.end(), one.begin(), sum.begin(), std::plus<>());
}

/// The reference that a contestant is held against, or none.
const Contestant* opponent(const std::vector<Contestant>& all, const Contestant& c,
                           const std::string& reference) {
  const Contestant* found = nullptr;
  for (const Contestant& other : all) {
    const bool stands = other.entry.group == c.entry.group && other.entry.controller == reference &&
                        other.entry.variant.label.empty();
    if (stands && (!found || other.entry.tuned == c.entry.tuned)) found = &other;
  }
  return found == &c ? nullptr : found;
}

/// a − b for every flight in which both have the figure.
std::vector<double> differences(std::string_view metric, const Contestant& a, const Contestant& b) {
  std::vector<double> values;
  for (std::size_t i = 0; i < a.flights.size(); ++i) {
    const double difference = figure(metric, a.flights[i].summary) - figure(metric, b.flights[i].summary);
    if (std::isfinite(difference)) values.push_back(difference);
  }
  return values;
}

}  // namespace

const std::vector<Metric>& metrics() {
  static const std::vector<Metric> kMetrics = {
      {"rmse_m", [](const FlightSummary& s) { return s.track.all.rmse_m; }},
      {"max_m", [](const FlightSummary& s) { return s.track.all.max_m; }},
      {"mean_m", [](const FlightSummary& s) { return s.track.all.mae_m; }},
      {"p95_m", [](const FlightSummary& s) { return s.track.p95_m; }},
      {"settled_rmse_m", [](const FlightSummary& s) { return s.track.settled_rmse_m; }},
      {"turn_max_m", [](const FlightSummary& s) { return s.track.turn_max_m; }},
      {"terminal_error_m", terminal_error_m},
      {"duration_s", [](const FlightSummary& s) { return s.succeeded() ? s.duration_s : kNaN; }},
      {"tilt_rate_rms_rad_s", [](const FlightSummary& s) { return s.tilt_rate_rms_rad_s; }},
      {"hold_mean_m", [](const FlightSummary& s) { return s.hold.mean_m; }},
      {"hold_max_m", [](const FlightSummary& s) { return s.hold.max_m; }},
  };
  return kMetrics;
}

double figure(std::string_view metric, const FlightSummary& summary) {
  const auto it = std::find_if(metrics().begin(), metrics().end(),
                               [metric](const Metric& m) { return m.name == metric; });
  assert(it != metrics().end());
  return it->of(summary);
}

Standing standing_of(const Contestant& c) {
  Standing standing;
  standing.runs = static_cast<long>(c.flights.size());
  for (const ComparedFlight& flight : c.flights) {
    standing.arrived += flight.summary.succeeded() ? 1 : 0;
    standing.tracked += flight.summary.track.legs.empty() ? 0 : 1;
    ++standing.outcomes[flight.summary.outcome];
    add(standing.distribution, flight.summary.track.distribution);
  }
  standing.success_ci95 = wilson95(standing.arrived, standing.runs);
  for (const Metric& metric : metrics())
    standing.means.emplace(metric.name, mean_of(figures(metric.name, c)));
  standing.max_m = largest(figures("max_m", c));
  standing.hold_max_m = largest(figures("hold_max_m", c));
  standing.junction_accuracy = junction_accuracy(c);
  standing.perception_ms = mean_ms(c, &FlightTiming::perception);
  standing.control_ms = mean_ms(c, &FlightTiming::control);
  return standing;
}

std::vector<Pair> pairs_of(const std::vector<Contestant>& contestants, const std::string& reference) {
  std::vector<Pair> pairs;
  for (const Contestant& a : contestants) {
    const Contestant* b = opponent(contestants, a, reference);
    if (!b) continue;
    for (const Metric& metric : metrics()) {
      const std::vector<double> values = differences(metric.name, a, *b);
      pairs.push_back({&a.entry, &b->entry, metric.name, paired_difference(values)});
    }
  }
  return pairs;
}

}  // namespace lineservo::apps
