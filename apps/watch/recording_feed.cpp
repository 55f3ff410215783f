#include "apps/watch/recording_feed.h"

namespace lineservo::apps {

std::optional<WatchTick> RecordingFeed::next() {
  if (row_ == recording_.ticks.size()) return std::nullopt;
  const RecordedTick& recorded = recording_.ticks[row_++];
  WatchTick tick;
  tick.input = recorded.input;
  tick.frame = frames_;
  if (auto frame = read_frame(recording_, recorded)) {
    tick.bgr = std::move(*frame);
    ++frames_;
  }
  return tick;
}

}  // namespace lineservo::apps
