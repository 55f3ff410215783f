#include "apps/watch/open_watch.h"

#include <fmt/format.h>

#include "apps/config/camera/camera_file.h"
#include "apps/config/camera/image_size.h"
#include "apps/config/input_error.h"
#include "apps/config/numbers.h"
#include "apps/config/settings_table.h"
#include "apps/flight/convert.h"
#include "apps/grabber/load_grabbers.h"
#include "apps/watch/estimates_file.h"
#include "apps/watch/grabber_feed.h"
#include "apps/watch/recording_feed.h"
#include "apps/watch/sim_feed.h"
#include "vehicle/grabber/source_name.h"

namespace lineservo::apps {
namespace {

using vehicle::SourceKind;

constexpr const char* kDefaultController = "ibvs";

template <typename Option>
void refuse(const Option& typed, const char* name, const WatchRequest& request, const char* why) {
  if (typed) throw InputError(fmt::format("watch: {} does not go with {}: {}", name, request.source, why));
}

/// A recording and a simulated flight have their own camera and estimates.
void refuse_own_eyes(const WatchRequest& request, const char* why) {
  refuse(request.camera, "--camera", request, why);
  refuse(request.scale_camera, "--scale-camera", request, why);
  refuse(request.height, "--height", request, why);
  refuse(request.rate, "--rate", request, why);
}

void apply_typed(FlightRequest& flight, const WatchRequest& request) {
  if (request.speed) SettingsTable(flight.settings).set("speed_m_s", *request.speed, "--speed");
  for (const std::string& assignment : request.overrides) apply_override(flight, assignment);
}

FlightRequest flight_request(const WatchRequest& request) {
  FlightRequest flight;
  if (request.seed)  // it may draw conditions
    flight.seed = read_seed(*request.seed, fmt::format("--seed {}", *request.seed));
  apply_conditions(flight, request.conditions.value_or(flight.conditions));
  return flight;
}

std::vector<std::string> controllers_of(const WatchRequest& request,
                                        const std::vector<std::string>& otherwise) {
  return request.controllers.empty() ? otherwise : request.controllers;
}

OpenWatch open_recording(const WatchRequest& request) {
  refuse_own_eyes(request, "a recording has its own camera and estimates");
  refuse(request.conditions, "--conditions", request, "a recording has its own settings; use --set");
  refuse(request.seed, "--seed", request, "a recording draws nothing");
  for (const std::string& assignment : request.overrides)
    refuse(assignment.starts_with("camera."), "--set camera.", request, "a recording has its own camera");
  Recording recording = read_recording(request.source);
  OpenWatch opened{recording.request, controllers_of(request, recording.info.controllers), nullptr};
  apply_typed(opened.request, request);
  opened.feed = std::make_unique<RecordingFeed>(std::move(recording));
  return opened;
}

/// Flown by the first of the controllers.
OpenWatch open_sim(const WatchRequest& request, const SimSource& sim) {
  refuse_own_eyes(request, "a simulated flight has its own camera and estimates");
  OpenWatch opened{flight_request(request), controllers_of(request, {kDefaultController}), nullptr};
  apply_typed(opened.request, request);
  opened.request.instruction = sim.target;
  opened.request.layout = sim.layout;
  opened.request.controller = opened.controllers.front();
  opened.feed = std::make_unique<SimFeed>(prepare(opened.request));
  return opened;
}

/// A number is the height of flight as well: the laws do not climb.
Estimates estimates_of(const WatchRequest& request, Settings& settings) {
  if (!request.height) return Estimates(settings.height_m);
  if (!parse_number(*request.height, -1e9, 1e9)) return read_estimates(*request.height);
  SettingsTable(settings).set("height_m", *request.height, "--height");
  return Estimates(settings.height_m);
}

features::CameraParameters camera_of(const WatchRequest& request, const Settings& settings,
                                     const vehicle::SourceFormat& format) {
  const OtherSize other = request.scale_camera ? OtherSize::scale : OtherSize::refuse;
  if (request.camera)
    return camera_for_size(read_camera(*request.camera), format.width_px, format.height_px, other);
  const features::CameraParameters camera = camera_parameters(settings.camera);
  if (camera.width_px != format.width_px || camera.height_px != format.height_px)
    throw InputError(
        fmt::format("watch: {} is {}×{} px, the camera without --camera {}×{}: give a camera file by "
                    "--camera FILE",
                    request.source, format.width_px, format.height_px, camera.width_px, camera.height_px));
  return camera;
}

vehicle::GrabberOptions grabber_options(const WatchRequest& request, const Settings& settings) {
  vehicle::GrabberOptions options;
  const features::CameraParameters camera =
      request.camera ? read_camera(*request.camera) : camera_parameters(settings.camera);
  options.width_px = camera.width_px;
  options.height_px = camera.height_px;
  if (!request.rate) return options;
  const auto rate_hz = parse_number(*request.rate, 0.1, 1000.0);
  if (!rate_hz)
    throw InputError(fmt::format("watch: --rate '{}': must be a number from 0.1 to 1000", *request.rate));
  options.rate_hz = *rate_hz;
  return options;
}

bool is_live(SourceKind kind) {
  return kind == SourceKind::device || kind == SourceKind::stream || kind == SourceKind::pipeline;
}

/// What a camera gives may be other than what it was asked for.
void tell(const std::string& source, const vehicle::SourceFormat& format,
          const vehicle::GrabberOptions& asked) {
  const std::string rate = format.rate_hz > 0.0 ? fmt::format("{:g}", format.rate_hz) : "an untold number of";
  fmt::print(stderr, "lineservo: watch: {}: {}×{} px at {} frames/s (asked for: {}×{} at {:g})\n", source,
             format.width_px, format.height_px, rate, asked.width_px, asked.height_px, asked.rate_hz);
}

OpenWatch open_frames(const WatchRequest& request) {
  if (request.scale_camera && !request.camera)
    throw InputError("watch: --scale-camera needs a --camera to scale");
  OpenWatch opened{flight_request(request), controllers_of(request, {kDefaultController}), nullptr};
  apply_typed(opened.request, request);
  opened.request.controller = opened.controllers.front();
  Settings& settings = opened.request.settings;
  Estimates estimates = estimates_of(request, settings);
  const vehicle::GrabberOptions options = grabber_options(request, settings);
  auto source = load_source(request.source, options);
  const vehicle::SourceFormat format = source->format();
  const bool live = is_live(vehicle::source_kind(request.source));
  if (live) tell(request.source, format, options);
  opened.feed = std::make_unique<GrabberFeed>(std::move(source), camera_of(request, settings, format),
                                              std::move(estimates), live ? Pace::live : Pace::files);
  return opened;
}

}  // namespace

OpenWatch open_watch(const WatchRequest& request) {
  for (const std::string& name : request.controllers) servo::find_controller(name);
  if (const auto sim = sim_source(request.source)) return open_sim(request, *sim);
  if (is_recording(request.source)) return open_recording(request);
  return open_frames(request);
}

}  // namespace lineservo::apps
