#include "apps/overlay/flight_scene.h"

#include "apps/flight/convert.h"

namespace lineservo::apps {

Overlay flight_overlay(const Mission& mission, std::vector<std::string> notes) {
  const FlightRequest& request = mission.request;
  OverlayOptions options{request.instruction, request.controller, request.settings.speed_m_s,
                         std::move(notes)};
  return {camera_parameters(request.settings.camera), std::move(options), mission.floor, mission.plan};
}

OverlayScene scene_of(const FlightTick& tick) {
  const servo::Executive& executive = tick.chain.executive();
  OverlayScene scene;
  scene.bgr = tick.bgr;
  if (tick.bgr) scene.mask = &tick.chain.mask();
  scene.features = tick.features;
  scene.view = tick.chain.view();
  scene.law_view = tick.chain.law_view();
  scene.command = tick.command;
  scene.time_s = vehicle::seconds(tick.input.now);
  scene.height_m = tick.truth.p_WB.z();
  scene.phase = servo::name(executive.phase());
  if (executive.step() < executive.plan().steps.size())
    scene.next = executive.plan().steps[executive.step()].expected;
  scene.vehicle = MapPose{tick.truth.p_WB.head<2>(), tick.truth.heading_rad};
  return scene;
}

}  // namespace lineservo::apps
