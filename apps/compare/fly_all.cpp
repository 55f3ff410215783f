#include "apps/compare/fly_all.h"

#include <atomic>
#include <opencv2/core/utility.hpp>

#include "apps/compare/parallel.h"

namespace lineservo::apps {

std::optional<std::vector<FlightSummary>> fly_all(const std::vector<FlightTask>& tasks, int jobs,
                                                  const std::function<bool(std::size_t)>& watch) {
  cv::setNumThreads(1);  // the flights are what runs in parallel
  std::vector<FlightSummary> summaries(tasks.size());
  std::atomic<bool> broken_off = false;
  const auto fly = [&](std::size_t i) {
    Mission mission = *tasks[i].mission;
    mission.request.seed = tasks[i].seed;
    if (tasks[i].settings) mission.request.settings = *tasks[i].settings;
    FlownMission flown = fly_mission(mission, [&](const FlightProgress&) { return !broken_off; });
    if (tasks[i].trace) *tasks[i].trace = trace_of(mission, flown);
    summaries[i] = std::move(flown.summary);
  };
  const bool all_flown = for_each_index(tasks.size(), jobs, fly, [&](std::size_t done) {
    if (!watch(done)) broken_off = true;
    return !broken_off;
  });
  if (!all_flown || broken_off) return std::nullopt;
  return summaries;
}

}  // namespace lineservo::apps
