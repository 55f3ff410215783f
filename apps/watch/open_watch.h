#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/config/flight_request.h"
#include "apps/watch/watch_feed.h"

namespace lineservo::apps {

/// What is to be watched, as typed; what was not typed keeps the recording's value or the default.
struct WatchRequest {
  std::string source;  ///< a recording, sim:LAYOUT/TARGET, or what vehicle::open_source() takes
  std::vector<std::string> controllers, overrides;
  std::optional<std::string> camera, height, conditions, speed, seed, rate;
  bool scale_camera = false;
};

/// A source that is open, and what looks at it.
struct OpenWatch {
  FlightRequest request;  ///< its settings are those in force
  std::vector<std::string> controllers;
  std::unique_ptr<WatchFeed> feed;
};

/// Throws InputError or std::invalid_argument: a source that is not there or shows no frame, a camera of
/// another size, an option that does not go with the source.
OpenWatch open_watch(const WatchRequest& request);

}  // namespace lineservo::apps
