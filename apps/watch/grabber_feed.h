#pragma once

#include <memory>

#include "apps/watch/estimates.h"
#include "apps/watch/watch_feed.h"
#include "vehicle/grabber/frame_source.h"

namespace lineservo::apps {

/// Whether frames come as they are taken, or as fast as they are asked for.
enum class Pace { live, files };

/// Frames of a source. Time counts from its first frame. Of files a tick is at its frame's stamp; of live
/// sources when the frame is handed on.
class GrabberFeed final : public WatchFeed {
 public:
  /// The camera must have the source's size.
  GrabberFeed(std::unique_ptr<vehicle::FrameSource> source, const features::CameraParameters& camera,
              Estimates estimates, Pace pace);

  const features::CameraParameters& camera() const override { return camera_; }
  bool is_live() const override { return pace_ == Pace::live; }
  std::optional<WatchTick> next() override;

 private:
  std::unique_ptr<vehicle::FrameSource> source_;
  features::CameraParameters camera_;
  Estimates estimates_;
  Pace pace_;
  std::optional<servo::Time> begin_;  ///< stamp of the first frame
};

}  // namespace lineservo::apps
