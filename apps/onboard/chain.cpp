#include "apps/onboard/chain.h"

#include <utility>

#include "apps/flight/convert.h"

namespace lineservo::apps {
namespace {

servo::Observation observation_of(const TickInput& input, features::FrameFeatures features) {
  servo::Observation o;
  o.now = input.now;
  o.captured = input.captured;
  o.features = std::move(features);
  o.has_frame = input.has_frame;
  o.estimate = input.estimate;
  return o;
}

}  // namespace

Chain::Chain(const features::CameraParameters& camera, const Settings& settings,
             const servo::Controller& controller)
    : perception_(features::CameraModel(camera), perception_options(settings.features, controller)),
      corrects_tilt_(settings.features.tilt_correction),
      law_corrects_tilt_(controller.needs.tilt_corrected),
      faults_(software_faults(settings.faults)) {}

features::FrameFeatures Chain::see(const TickInput& input, const cv::Mat& bgr) {
  features::FrameContext context;
  if (corrects_tilt_) context.view = features::LevelView(input.roll_rad, input.pitch_rad);
  context.height_m = input.estimate.capture_height_m;
  context.since_last_s = ticks_ == 0 ? 0.0 : servo::seconds(input.exposed - last_exposed_);
  context.on_the_way = on_the_way();
  last_exposed_ = input.exposed;
  view_ = context.view;
  features::FrameFeatures features = perception_.observe(bgr, context);
  spoil(features, faults_, input.exposed);
  return features;
}

servo::Command Chain::command(const TickInput& input, features::FrameFeatures features) {
  ++ticks_;
  observation_ = observation_of(input, std::move(features));
  spoil(observation_, faults_, observation_.now);
  return decide(observation_, input.on_ground);
}

}  // namespace lineservo::apps
