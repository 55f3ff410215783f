#pragma once

#include <deque>
#include <string>

#include "apps/flight/mission.h"
#include "apps/watch/watch_feed.h"

namespace lineservo::apps {

/// The frames and estimates of a simulated flight, as they reach its controller.
class SimFeed final : public WatchFeed {
 public:
  explicit SimFeed(const Mission& mission);

  const features::CameraParameters& camera() const override { return camera_; }
  std::optional<WatchTick> next() override;

 private:
  features::CameraParameters camera_;
  Flight flight_;
  std::deque<WatchTick> ticks_;
  std::int64_t frames_ = 0;
};

/// What "sim:warehouse/a13" or "sim:a13" stands for.
struct SimSource {
  std::string layout, target;
};
/// None when the name does not begin with "sim:". Throws InputError when no target comes behind it.
std::optional<SimSource> sim_source(const std::string& name);

}  // namespace lineservo::apps
