#include "apps/overlay/watch_scene.h"

namespace lineservo::apps {

Overlay watch_overlay(const OpenWatch& opened, const std::string& source, std::vector<std::string> notes) {
  OverlayOptions options{source, opened.controllers.front(), opened.request.settings.speed_m_s,
                         std::move(notes)};
  return {opened.feed->camera(), std::move(options)};
}

OverlayScene scene_of(const Watched& watched) {
  OverlayScene scene;
  const ChainOutput& output = watched.outputs.front();
  const bool has_frame = !watched.tick.bgr.empty();
  if (has_frame) {
    scene.bgr = &watched.tick.bgr;
    scene.mask = &watched.chain->mask();
  }
  scene.features = output.features;
  scene.view = watched.chain->view();
  scene.law_view = watched.chain->law_view();
  scene.command = output.command;
  scene.time_s = servo::seconds(watched.tick.input.now);
  scene.height_m = watched.tick.input.estimate.height_m;
  return scene;
}

}  // namespace lineservo::apps
