#include "apps/compare/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>

#include "apps/compare/fly_again.h"
#include "apps/config/conditions_range.h"
#include "apps/config/input_error.h"
#include "apps/config/settings_table.h"
#include "apps/config/tuned_settings.h"

namespace lineservo::apps {
namespace {

/// The speed that an entry is asked to fly; none: that of the conditions.
std::optional<double> own_speed_of(const std::string& controller) {
  const double published_m_s = servo::find_controller(controller).published_speed_m_s;
  return published_m_s > 0.0 ? std::optional(published_m_s) : std::nullopt;
}

/// conditions ← speed ← tuned parameters ← the block's, the variant's and the user's settings
void complete(Entry& entry, const ComparisonOptions& options) {
  const std::optional<double> speed_m_s = entry.asked_speed_m_s;
  FlightRequest& request = entry.request;
  apply_conditions(request, options.conditions);
  request.controller = entry.controller;
  request.layout = entry.layout;
  if (speed_m_s) SettingsTable(request.settings).set("speed_m_s", fmt::format("{}", *speed_m_s), "--speeds");
  if (entry.tuned) apply_shipped_tuned(request, "--tuning tuned");
  for (const std::string& assignment : entry.overrides) apply_override(request, assignment);
  entry.speed_m_s = request.settings.speed_m_s;
}

/// Conditions between two others, and nothing that sets the speed.
bool draws_speed(const Entry& entry, const ComparisonOptions& options) {
  const bool is_set = std::any_of(entry.overrides.begin(), entry.overrides.end(),
                                  [](const std::string& set) { return set.starts_with("speed_m_s="); });
  return conditions_range(options.conditions) && !entry.asked_speed_m_s && !is_set;
}

std::vector<bool> tunings(const std::string& controller, Tuning wanted) {
  servo::find_controller(controller);
  if (wanted == Tuning::published) return {false};
  if (wanted == Tuning::tuned) return {true};
  return tuned_file(controller) ? std::vector<bool>{false, true} : std::vector<bool>{false};
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// All controllers of a block on one layout at one speed.
void add_group(std::vector<Entry>& entries, const Entry& common, const Block& block,
               std::optional<double> speed_m_s, const ComparisonOptions& options) {
  for (const std::string& controller : block.controllers) {
    for (const bool tuned : tunings(controller, options.tuning)) {
      for (const Variant& variant : block.variants) {
        Entry entry = common;
        entry.controller = controller;
        entry.tuned = tuned;
        entry.variant = variant;
        entry.overrides = joined(joined(block.overrides, variant.overrides), options.overrides);
        entry.asked_speed_m_s = block.own_speed ? own_speed_of(controller) : speed_m_s;
        complete(entry, options);
        if (draws_speed(entry, options)) entry.speed_m_s = std::numeric_limits<double>::quiet_NaN();
        entries.push_back(std::move(entry));
      }
    }
  }
}

void add_block(std::vector<Entry>& entries, const Block& block, const ComparisonOptions& options) {
  std::vector<std::optional<double>> speeds(block.speeds_m_s.begin(), block.speeds_m_s.end());
  if (speeds.empty()) speeds = {std::nullopt};
  for (const std::string& layout : block.layouts) {
    for (const auto& speed_m_s : speeds) {
      Entry common;
      common.group = fmt::format("{}|{}|{}|{}|{}", block.title, layout, fmt::join(block.instructions, ","),
                                 speed_m_s.value_or(0.0), block.own_speed);
      common.title = block.title;
      common.layout = layout;
      common.instructions = block.instructions;
      common.own_speed = block.own_speed;
      add_group(entries, common, block, speed_m_s, options);
    }
  }
}

std::string key_of(const std::string& assignment) {
  return assignment.substr(0, assignment.find('='));
}

/// The settings that tell the rows of a block apart.
std::set<std::string> keys_of(const Block& block) {
  std::set<std::string> keys;
  if (block.own_speed || !block.speeds_m_s.empty()) keys.insert("speed_m_s");
  for (const Variant& variant : block.variants)
    for (const std::string& assignment : variant.overrides) keys.insert(key_of(assignment));
  return keys;
}

/// A setting for every flight would win over these, and the rows would not be what their labels say.
void refuse_overruled(const Block& block, const ComparisonOptions& options) {
  const std::set<std::string> keys = keys_of(block);
  for (const std::string& assignment : options.overrides) {
    if (!keys.contains(key_of(assignment))) continue;
    throw InputError(fmt::format("--set {}: cannot go with --speeds, --own-speed or --preset, which set it",
                                 key_of(assignment)));
  }
}

void check_seeds(const ComparisonOptions& options) {
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t highest = kLast - static_cast<std::uint64_t>(options.runs - 1);
  if (options.seed <= highest) return;
  throw InputError(fmt::format("--seed {}: with --runs {} the seeds would pass {}; it may be at most {}",
                               options.seed, options.runs, kLast, highest));
}

void check_count(const std::vector<Entry>& entries, const ComparisonOptions& options) {
  std::size_t of_each_run = 0;
  for (const Entry& entry : entries) of_each_run += entry.instructions.size();
  const auto runs = static_cast<std::size_t>(options.runs);
  if (runs * of_each_run <= kMostFlights) return;
  throw InputError(
      fmt::format("--runs {}: makes {} flights, {} for each run; at most {} are allowed: --runs {}", runs,
                  runs * of_each_run, of_each_run, kMostFlights, kMostFlights / of_each_run));
}

/// What the flight's own command draws.
Settings drawn_settings(const Entry& common, std::uint64_t seed, const ComparisonOptions& options) {
  Entry entry = common;
  entry.request = FlightRequest{};  // the entry's own was drawn already, for another seed
  entry.request.seed = seed;
  complete(entry, options);
  return entry.request.settings;
}

}  // namespace

std::vector<Block> on_floors_of_zones(const Block& block) {
  std::vector<Block> blocks;
  for (const std::string& instruction : block.instructions) {
    const std::vector<std::string> floor = {layout_of_zone(instruction)};
    auto it = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.layouts == floor; });
    if (it == blocks.end()) {
      it = blocks.insert(blocks.end(), block);
      it->layouts = floor;
      it->instructions.clear();
    }
    it->instructions.push_back(instruction);
  }
  return blocks;
}

std::string Entry::label() const {
  return controller + (tuned ? " tuned" : "") + (variant.label.empty() ? "" : " " + variant.label);
}

std::vector<Entry> entries_of(const ComparisonOptions& options) {
  check_seeds(options);
  for (const Block& block : options.blocks) refuse_overruled(block, options);
  std::vector<Entry> entries;
  for (const Block& block : options.blocks) add_block(entries, block, options);
  check_count(entries, options);
  const std::string reference = reference_of(options);
  if (std::none_of(entries.begin(), entries.end(),
                   [&](const Entry& e) { return e.controller == reference; })) {
    throw InputError(fmt::format("--reference {}: does not fly; it must be among --controllers", reference));
  }
  return entries;
}

Comparison::Comparison(const ComparisonOptions& options) {
  for (Entry& entry : entries_of(options)) {
    Contestant& contestant = contestants_.emplace_back(Contestant{std::move(entry), {}});
    for (const std::string& instruction : contestant.entry.instructions)
      add_flights(contestant, instruction, options);
  }
}

void Comparison::add_flights(Contestant& contestant, const std::string& instruction,
                             const ComparisonOptions& options) {
  FlightRequest request = contestant.entry.request;
  request.instruction = instruction;
  missions_.push_back(prepare(request));
  const bool draws = conditions_range(options.conditions).has_value();
  for (int run = 0; run < options.runs; ++run) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(run);
    const Settings* own =
        draws ? &drawn_.emplace_back(drawn_settings(contestant.entry, seed, options)) : nullptr;
    tasks_.push_back({&missions_.back(), seed, own, run == 0 ? &traces_.emplace_back() : nullptr});
    contestant.flights.push_back({instruction, seed, fly_again(contestant.entry, instruction, seed), {}});
  }
}

std::optional<std::vector<Contestant>> Comparison::fly(int jobs,
                                                       const std::function<bool(std::size_t)>& watch) {
  auto summaries = fly_all(tasks_, jobs, watch);
  if (!summaries) return std::nullopt;
  std::vector<Contestant> flown = contestants_;
  auto summary = summaries->begin();
  auto task = tasks_.begin();
  for (Contestant& contestant : flown) {
    for (ComparedFlight& flight : contestant.flights) {
      flight.summary = std::move(*summary++);
      if (const FlightTrace* trace = (task++)->trace) flight.trace = *trace;
    }
  }
  return flown;
}

std::string reference_of(const ComparisonOptions& options) {
  if (options.reference) return *options.reference;
  for (const Block& block : options.blocks) {
    if (std::count(block.controllers.begin(), block.controllers.end(), "ibvs") > 0) return "ibvs";
  }
  return options.blocks.front().controllers.front();
}

}  // namespace lineservo::apps
