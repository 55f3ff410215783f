#include "apps/compare/tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/compare/fly_all.h"
#include "apps/compare/search.h"
#include "apps/config/program_name.h"
#include "apps/config/settings_table.h"
#include "apps/config/tuned_settings.h"
#include "apps/version.h"

namespace lineservo::apps {
namespace {

constexpr double kLargestFactor = 8.0;  // of a parameter, about its published value

// Saturations and guards, how the image is cut, the pace and the yaw in bends, which no training flight has,
// and what turns pitch or steps into speed or a law's units into others: they say when and how fast, not how
// well a law follows.
constexpr std::array<std::string_view, 14> kNotTuned = {
    "limit",      "coast_s", "view_margin", "view_angle", "width",     "bend_",  "pitch_speed",
    "channel_us", "max_",    "yaw_gamma",   "yaw_clip",   "yaw_focal", "arc_px", "step_m_per_px"};

struct TrainingTrack {
  const char* instruction;
  const char* layout;
};
constexpr std::array<TrainingTrack, 3> kTracks = {
    {{"a13", "warehouse"}, {"a13", "tape-warehouse"}, {"node:end", "straight"}}};
constexpr std::array<std::uint64_t, 3> kSeeds = {9001, 9002, 9003};
constexpr const char* kConditions = "paper";

// What costs 1: a leg RMSE, a terminal error, a tilt rate; and what a flight that fails costs.
constexpr double kRmse_m = 0.05, kTerminal_m = 0.05, kTiltRate_rad_s = 0.1, kFailure = 20.0;

bool is_tuned(const std::string& key) {
  return std::none_of(kNotTuned.begin(), kNotTuned.end(),
                      [&key](std::string_view part) { return key.find(part) != std::string::npos; });
}

FlightRequest training_request(const std::string& controller) {
  FlightRequest request;
  apply_conditions(request, kConditions);
  request.controller = controller;
  return request;
}

/// The search runs on log(value / published); four digits are enough for a gain.
double value_at(const TunableParameter& p, double log_factor) {
  if (log_factor == 0.0) return p.published;
  const double value = std::stod(fmt::format("{:.4g}", p.published * std::exp(log_factor)));
  return std::clamp(value, p.low, p.high);
}

std::vector<double> values_at(const std::vector<TunableParameter>& parameters, const std::vector<double>& x) {
  std::vector<double> values;
  for (std::size_t i = 0; i < x.size(); ++i) values.push_back(value_at(parameters[i], x[i]));
  return values;
}

SearchBox box_of(const std::vector<TunableParameter>& parameters) {
  SearchBox box;
  for (const TunableParameter& p : parameters) {
    box.start.push_back(0.0);
    box.low.push_back(std::log(p.low / p.published));
    box.high.push_back(std::log(p.high / p.published));
  }
  return box;
}

struct BrokenOff {};

/// Flies the training flights for one point after another.
class Trainer {
 public:
  Trainer(TuningResult& result, int jobs, const std::function<bool(std::size_t)>& watch)
      : result_(result), jobs_(jobs), watch_(watch) {
    for (const TrainingTrack& track : kTracks) {
      FlightRequest request = training_request(result.controller);
      request.instruction = track.instruction;
      request.layout = track.layout;
      missions_.push_back(prepare(request));
    }
  }

  double cost(const std::vector<double>& x) {
    TuningTrial trial{values_at(result_.parameters, x), 0.0, 0};
    const std::vector<FlightSummary> flights = fly(trial.values);
    for (const FlightSummary& flight : flights) {
      trial.cost += flight_cost(flight) / static_cast<double>(flights.size());
      trial.failed += flight.succeeded() ? 0 : 1;
    }
    result_.trials.push_back(trial);
    return trial.cost;
  }

 private:
  std::vector<FlightSummary> fly(const std::vector<double>& values) {
    std::vector<FlightTask> tasks;
    for (Mission& mission : missions_) {
      SettingsTable table(mission.request.settings);
      for (std::size_t i = 0; i < values.size(); ++i)
        table.set(result_.parameters[i].key, fmt::format("{}", values[i]), "tune");
      for (const std::uint64_t seed : kSeeds) tasks.push_back({&mission, seed});
    }
    auto flights = fly_all(tasks, jobs_, [this](std::size_t) { return watch_(result_.trials.size()); });
    if (!flights) throw BrokenOff();
    return std::move(*flights);
  }

  TuningResult& result_;
  int jobs_;
  const std::function<bool(std::size_t)>& watch_;
  std::vector<Mission> missions_;
};

}  // namespace

std::vector<TunableParameter> tunable_parameters(const std::string& controller) {
  servo::find_controller(controller);
  FlightRequest request = training_request(controller);
  const SettingsTable table(request.settings);
  std::vector<TunableParameter> parameters;
  for (const Setting& setting : table.all()) {
    if (!setting.range || !is_law_key(controller, setting.key) || !is_tuned(setting.key)) continue;
    const double published = std::stod(setting.get());
    if (published <= 0.0) continue;  // a term that the law flies without, as published
    parameters.push_back({setting.key, published, std::max(setting.range->low, published / kLargestFactor),
                          std::min(setting.range->high, published * kLargestFactor)});
  }
  return parameters;
}

double flight_cost(const FlightSummary& s) {
  if (!s.succeeded() || !s.rest) return kFailure;
  return s.track.all.rmse_m / kRmse_m + s.rest->target_error_m / kTerminal_m +
         s.tilt_rate_rms_rad_s / kTiltRate_rad_s;
}

const TuningTrial& TuningResult::best() const {
  return *std::min_element(trials.begin(), trials.end(),
                           [](const TuningTrial& a, const TuningTrial& b) { return a.cost < b.cost; });
}

std::optional<TuningResult> tune(const std::string& controller, const TuningOptions& options,
                                 const std::function<bool(std::size_t)>& watch) {
  TuningResult result{controller, tunable_parameters(controller), {}};
  Trainer trainer(result, options.jobs, watch);
  try {
    search_minimum(box_of(result.parameters), options.budget,
                   [&trainer](const std::vector<double>& x) { return trainer.cost(x); });
  } catch (const BrokenOff&) {
    return std::nullopt;
  }
  return result;
}

std::string tuned_yaml(const TuningResult& result) {
  const TuningTrial& best = result.best();
  std::string yaml = fmt::format(
      "# {} tuned: `{} tune {} --budget {}` (version {}); training cost {:.4f}, as published {:.4f}\n",
      result.controller, program_name(), result.controller, result.trials.size(), kVersion, best.cost,
      result.published().cost);
  for (std::size_t i = 0; i < best.values.size(); ++i) {
    const std::string& key = result.parameters[i].key;
    yaml += fmt::format("{}: {}\n", key, best.values[i]);
  }
  return yaml;
}

}  // namespace lineservo::apps
