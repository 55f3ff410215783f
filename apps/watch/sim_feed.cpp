#include "apps/watch/sim_feed.h"

#include "apps/config/flight_request.h"
#include "apps/config/input_error.h"
#include "apps/flight/convert.h"

namespace lineservo::apps {

SimFeed::SimFeed(const Mission& mission)
    : camera_(camera_parameters(mission.request.settings.camera)),
      flight_(mission.request, mission.floor, mission.plan) {
  flight_.listen([this](const FlightTick& tick) {
    ticks_.push_back({tick.input, tick.bgr ? *tick.bgr : cv::Mat(), frames_});
    if (tick.bgr) ++frames_;
  });
}

std::optional<WatchTick> SimFeed::next() {
  while (ticks_.empty())
    if (!flight_.step()) return std::nullopt;
  WatchTick tick = std::move(ticks_.front());
  ticks_.pop_front();
  return tick;
}

std::optional<SimSource> sim_source(const std::string& name) {
  constexpr std::string_view kPrefix = "sim:";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  const std::string flown = name.substr(kPrefix.size());
  const std::size_t slash = flown.rfind('/');
  const std::string target = slash == flown.npos ? flown : flown.substr(slash + 1);
  if (target.empty() || slash == 0)
    throw InputError(name + ": must be sim:LAYOUT/TARGET, such as sim:warehouse/a13, or sim:TARGET");
  return SimSource{slash == flown.npos ? layout_of_zone(target) : flown.substr(0, slash), target};
}

}  // namespace lineservo::apps
