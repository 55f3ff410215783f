#include "apps/flight/mission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/config/data_folder.h"
#include "apps/config/input_error.h"
#include "apps/config/layout_file.h"
#include "apps/config/layout_topology.h"
#include "apps/config/mission_file.h"
#include "apps/config/text_file.h"
#include "servo/law/controllers.h"
#include "servo/plan/pursuit.h"

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

/// How far ahead of the middle the camera sees from its height.
double view_m(const Settings& settings) {
  const double half_px = 0.5 * std::min(settings.camera.width_px, settings.camera.height_px);
  return settings.height_m * half_px / settings.camera.focal_px;
}

std::size_t target_of(const servo::Topology& topology, const std::string& target) try {
  return servo::find_target(topology, target);
} catch (const std::invalid_argument& fault) {
  if (!target.starts_with("node:")) throw;  // names the instructions that there are
  std::vector<std::string> nodes;
  for (const servo::TopologyNode& node : topology.nodes) nodes.push_back(node.name);
  throw InputError(fmt::format("{}; it has: {}", fault.what(), fmt::join(nodes, ", ")));
}

/// A disc that is painted as the end of a way is there to land on.
bool is_end_marker(const vehicle::Layout& floor, std::size_t node) {
  const auto lies_on = [&](const vehicle::LayoutMarker& marker) {
    return marker.p_W == floor.nodes[node].p_W;
  };
  return std::any_of(floor.end_markers.begin(), floor.end_markers.end(), lies_on);
}

servo::Plan mission_plan(const servo::Topology& topology, const FlightRequest& request) {
  const MissionFile mission = read_mission(find_data(DataKind::mission, request.instruction));
  servo::PlanBuilder builder(topology, request.instruction);
  for (const MissionTarget& target : mission.targets) {
    try {
      const std::size_t node = target.target == kReturn ? topology.start : target_of(topology, target.target);
      builder.visit({node, target.target, target.stop});
    } catch (const std::exception& fault) {
      throw InputError(fmt::format("{}:{}: {}", mission.file.string(), target.line, fault.what()));
    }
  }
  return builder.plan();
}

servo::Plan plan_of(const servo::Topology& topology, const FlightRequest& request) {
  if (is_mission_file(request.instruction)) return mission_plan(topology, request);
  return servo::compile(topology, target_of(topology, request.instruction), request.instruction);
}

}  // namespace

Mission prepare(const FlightRequest& request) {
  check_text(request);
  const servo::Controller& controller = servo::find_controller(request.controller);
  vehicle::Layout floor = read_layout(find_data(DataKind::layout, request.layout));
  servo::Topology topology = topology_of(floor);
  topology.view_m = view_m(request.settings);
  const servo::Plan plan = plan_of(topology, request);
  const auto pursuit = controller.traits.pursues_line ? servo::pursuit_of(plan, topology) : std::nullopt;
  Mission mission{request, std::move(floor), pursuit.value_or(plan)};
  mission.request.land |=
      !is_mission_file(request.instruction) && is_end_marker(mission.floor, plan.route.back().to);
  return mission;
}

FlownMission fly_mission(const Mission& mission, const std::function<bool(const FlightProgress&)>& progress,
                         TickListener on_tick) {
  Flight flight(mission.request, mission.floor, mission.plan);
  flight.listen(std::move(on_tick));
  FlownMission flown{flight.run(progress), {}};
  flown.summary = summarise(mission.request, mission.floor, mission.plan, flown.record);
  return flown;
}

}  // namespace lineservo::apps
