#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "apps/config/settings.h"
#include "apps/onboard/chain.h"
#include "apps/onboard/chain_output.h"
#include "apps/watch/watch_feed.h"

namespace lineservo::apps {

/// What a tick came to: one output for each controller.
struct Watched {
  const WatchTick& tick;
  const std::vector<ChainOutput>& outputs;
  double perception_ms = 0.0;      ///< of the first controller, by the wall clock
  std::optional<double> delay_ms;  ///< of live sources: from the exposure until all have said their command
  const Chain* chain = nullptr;    ///< of the first controller
};

/// Each controller's chain on the same frames.
class WatchChains {
 public:
  /// Throws std::invalid_argument for an unknown controller, or a camera or options out of bounds.
  WatchChains(const features::CameraParameters& camera, const Settings& settings,
              const std::vector<std::string>& controllers);

  Watched look(const WatchTick& tick);

 private:
  std::vector<std::unique_ptr<Chain>> chains_;
  std::vector<ChainOutput> outputs_;
};

/// How watching ended.
struct WatchEnd {
  long frames = 0;
  bool interrupted = false;
  std::string broke_off;  ///< what the source said when it broke off; empty at its end
};

/// When watching ends before its source does.
struct WatchOptions {
  long frames = std::numeric_limits<long>::max();  ///< how many to look at
  std::function<bool()> goes_on = [] { return true; };
};

/// Frame after frame until the source ends or breaks off, the frames are enough, or it does not go on.
WatchEnd watch(WatchFeed& feed, WatchChains& chains, const WatchOptions& options,
               const std::function<void(const Watched&)>& on_tick);

}  // namespace lineservo::apps
