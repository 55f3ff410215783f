#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/recording/recording.h"
#include "servo/task/command.h"

namespace lineservo::apps {

/// A tick of a replay: what was recorded, and what the other controllers say.
struct ReplayedTick {
  const RecordedTick& recorded;
  const std::vector<servo::Command>& others;
};

/// Who looks at a recording besides its own controllers.
struct ReplayOptions {
  /// Controllers that see the same frames and estimates, beside those of the recording. Their commands move
  /// nothing.
  std::vector<std::string> others;
  /// Called for each tick; false breaks off.
  std::function<bool(const ReplayedTick&)> on_tick = {};
};

/// Runs perception and control again on a recording, tick by tick, and says in one line what differs first: a
/// frame, an estimate or a command that is not the one that was recorded, or features or a command that come
/// out otherwise. None: all is the same to the last bit.
std::optional<std::string> replay(const Recording& recording, const ReplayOptions& options = {});

}  // namespace lineservo::apps
