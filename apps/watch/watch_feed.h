#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "apps/onboard/tick_input.h"
#include "features/geometry/camera_model.h"

namespace lineservo::apps {

/// One tick of what is watched.
struct WatchTick {
  TickInput input;
  cv::Mat bgr;             ///< empty when the tick has no frame
  std::int64_t frame = 0;  ///< counts frames from 0
  /// On the monotonic clock, of cameras and streams.
  std::optional<servo::Time> exposed_at = {};
};

/// Frames with all that reaches the vehicle's computer along with them, one after the other.
class WatchFeed {
 public:
  WatchFeed() = default;
  virtual ~WatchFeed() = default;
  WatchFeed(const WatchFeed&) = delete;
  WatchFeed& operator=(const WatchFeed&) = delete;

  virtual const features::CameraParameters& camera() const = 0;
  /// It has no end of its own.
  virtual bool is_live() const { return false; }
  /// None at the end. Throws vehicle::GrabberError or InputError when it breaks off; what came before is
  /// good.
  virtual std::optional<WatchTick> next() = 0;
};

}  // namespace lineservo::apps
