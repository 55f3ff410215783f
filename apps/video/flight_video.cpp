#include "apps/video/flight_video.h"

namespace lineservo::apps {
namespace {

constexpr const char* kStem = "flight";
constexpr const char* kOwner = "config.yaml";  // beside it files are a flight's

}  // namespace

FlightVideo::FlightVideo(ResultFolder& folder, const Mission& mission)
    : overlay_(flight_overlay(mission)),
      file_(folder, kStem, kOwner, mission.request.settings.camera.frame_rate_hz, overlay_.size()) {
  leave_out_videos(folder, kStem, kOwner, file_.name());
}

void FlightVideo::add(const FlightTick& tick) {
  const TickInput& input = tick.input;
  const servo::Time seen = input.has_frame ? input.exposed : input.captured;
  file_.add(vehicle::seconds(seen), overlay_.draw(scene_of(tick)));
}

void FlightVideo::write() {
  file_.finish();
}

void leave_out_video(ResultFolder& folder) {
  leave_out_videos(folder, kStem, kOwner);
}

}  // namespace lineservo::apps
