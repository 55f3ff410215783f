#pragma once

#include "apps/recording/recording.h"
#include "apps/watch/watch_feed.h"

namespace lineservo::apps {

/// The frames and estimates of a recording.
class RecordingFeed final : public WatchFeed {
 public:
  explicit RecordingFeed(Recording recording) : recording_(std::move(recording)) {}

  const features::CameraParameters& camera() const override { return recording_.camera; }
  std::optional<WatchTick> next() override;

 private:
  Recording recording_;
  std::size_t row_ = 0;
  std::int64_t frames_ = 0;
};

}  // namespace lineservo::apps
