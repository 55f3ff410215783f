#include "apps/evaluate/fault_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <opencv2/core/utility.hpp>

#include "apps/compare/fly_again.h"
#include "apps/compare/parallel.h"
#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

constexpr std::uint64_t kFaultStream = 1004;  // of the flight's seed; convert.cpp has those before

std::vector<FaultCase> chosen(const std::vector<std::string>& names) {
  std::vector<FaultCase> cases;
  for (const FaultCase& one : fault_cases()) {
    const auto begins = [&one](const std::string& name) { return one.name.starts_with(name); };
    if (names.empty() || std::any_of(names.begin(), names.end(), begins)) cases.push_back(one);
  }
  if (!cases.empty()) return cases;
  std::vector<std::string> all;
  for (const FaultCase& one : fault_cases()) all.push_back(one.name);
  throw InputError(fmt::format("--faults {}: none of that name; allowed: {}", fmt::join(names, ","),
                               fmt::join(all, ", ")));
}

FlightRequest request_for(const FaultStudyOptions& options, const std::string& instruction) {
  FlightRequest request;
  apply_conditions(request, options.conditions);
  request.controller = options.controller;
  request.instruction = instruction;
  request.layout = layout_of_zone(instruction);
  for (const std::string& assignment : options.overrides) apply_override(request, assignment);
  return request;
}

std::string command_of(const FlightRequest& request, std::vector<std::string> overrides) {
  Entry entry;
  entry.controller = request.controller;
  entry.layout = request.layout;
  entry.speed_m_s = request.settings.speed_m_s;
  entry.overrides = std::move(overrides);
  entry.request = request;
  return fly_again(entry, request.instruction, request.seed);
}

/// The k-th flight of a fault.
FaultFlight fly_one(const FaultStudyOptions& options, const FaultCase& fault, Mission mission,
                    const std::atomic<bool>& broken_off) {
  FlightRequest& request = mission.request;
  vehicle::Random random(request.seed, kFaultStream);
  std::vector<std::string> overrides = options.overrides;
  for (std::string& assignment : fault.draw(mission, random)) {
    apply_override(request, assignment);
    overrides.push_back(std::move(assignment));
  }
  const FlownMission flown = fly_mission(mission, [&](const FlightProgress&) { return !broken_off; });
  return {request.instruction, request.seed, command_of(request, std::move(overrides)), flown.summary.outcome,
          assess_safety(flown.record, mission.floor)};
}

}  // namespace

std::optional<std::vector<FaultRow>> study_faults(
    const FaultStudyOptions& options, int jobs, const std::function<bool(std::size_t, std::size_t)>& watch) {
  const std::vector<FaultCase> cases = chosen(options.faults);
  std::vector<Mission> missions;
  for (const std::string& name : options.instructions)
    missions.push_back(prepare(request_for(options, name)));
  cv::setNumThreads(1);  // the flights are what runs in parallel
  const auto runs = static_cast<std::size_t>(options.runs);
  std::vector<FaultRow> rows;
  for (const FaultCase& one : cases) rows.push_back({one.name, std::vector<FaultFlight>(runs)});
  std::atomic<bool> broken_off = false;
  const auto fly = [&](std::size_t i) {
    const std::size_t run = i % runs;
    Mission mission = missions[run % missions.size()];
    mission.request.seed = options.seed + run;
    rows[i / runs].flights[run] = fly_one(options, cases[i / runs], std::move(mission), broken_off);
  };
  const std::size_t all = cases.size() * runs;
  const bool done = for_each_index(all, jobs, fly, [&](std::size_t flown) {
    if (!watch(flown, all)) broken_off = true;
    return !broken_off;
  });
  if (!done || broken_off) return std::nullopt;
  return rows;
}

}  // namespace lineservo::apps
