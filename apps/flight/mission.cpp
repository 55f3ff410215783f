#include "apps/flight/mission.h"

#include <fmt/format.h>

#include "apps/config/data_folder.h"
#include "apps/config/input_error.h"
#include "apps/config/layout_file.h"
#include "apps/config/layout_topology.h"
#include "apps/config/text_file.h"

namespace lineservo::apps {
namespace {

/// All of it goes into JSON and YAML, which hold UTF-8 alone.
void check_text(const FlightRequest& request) {
  for (const auto& [what, text] : {std::pair{"TARGET", &request.instruction},
                                   {"--layout", &request.layout},
                                   {"--conditions", &request.conditions}}) {
    if (!is_utf8(*text)) throw InputError(fmt::format("{} '{}': must be UTF-8 text", what, *text));
  }
}

}  // namespace

Mission prepare(const FlightRequest& request) {
  check_text(request);
  servo::find_controller(request.controller);
  vehicle::Layout floor = read_layout(find_data(DataKind::layout, request.layout));
  const servo::Topology topology = topology_of(floor);
  servo::Plan plan =
      servo::compile(topology, servo::find_target(topology, request.instruction), request.instruction);
  return {request, std::move(floor), std::move(plan)};
}

FlownMission fly_mission(const Mission& mission, const std::function<bool(const FlightProgress&)>& progress) {
  Flight flight(mission.request, mission.floor, mission.plan);
  FlownMission flown{flight.run(progress), {}};
  flown.summary = summarise(mission.request, mission.floor, mission.plan, flown.record);
  return flown;
}

}  // namespace lineservo::apps
