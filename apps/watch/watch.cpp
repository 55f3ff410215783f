#include "apps/watch/watch.h"

#include <chrono>

#include "apps/config/input_error.h"
#include "apps/onboard/follow_chain.h"
#include "vehicle/grabber/frame_source.h"

namespace lineservo::apps {
namespace {

using Clock = std::chrono::steady_clock;

double ms(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

/// The next tick; none at the end, and when the source breaks off.
std::optional<WatchTick> next_of(WatchFeed& feed, WatchEnd& end) try {
  return feed.next();
} catch (const vehicle::GrabberError& fault) {
  end.broke_off = fault.what();
  return std::nullopt;
} catch (const InputError& fault) {
  end.broke_off = fault.what();
  return std::nullopt;
}

}  // namespace

WatchChains::WatchChains(const features::CameraParameters& camera, const Settings& settings,
                         const std::vector<std::string>& controllers)
    : outputs_(controllers.size()) {
  for (const std::string& name : controllers)
    chains_.push_back(std::make_unique<FollowChain>(camera, settings, servo::find_controller(name)));
}

Watched WatchChains::look(const WatchTick& tick) {
  double perception_ms = 0.0;
  for (std::size_t k = 0; k < chains_.size(); ++k) {
    features::FrameFeatures features;
    const Clock::time_point begin = Clock::now();
    if (!tick.bgr.empty()) features = chains_[k]->see(tick.input, tick.bgr);
    if (k == 0) perception_ms = ms(Clock::now() - begin);
    outputs_[k].command = chains_[k]->command(tick.input, std::move(features));
    outputs_[k].features = chains_[k]->observation().features;
  }
  Watched watched{tick, outputs_, perception_ms, std::nullopt, chains_.front().get()};
  if (tick.exposed_at) watched.delay_ms = ms(Clock::now().time_since_epoch() - *tick.exposed_at);
  return watched;
}

WatchEnd watch(WatchFeed& feed, WatchChains& chains, const WatchOptions& options,
               const std::function<void(const Watched&)>& on_tick) {
  WatchEnd end;
  while (end.frames < options.frames) {
    end.interrupted = !options.goes_on();
    if (end.interrupted) break;
    const std::optional<WatchTick> tick = next_of(feed, end);
    if (!tick) break;
    if (!tick->bgr.empty()) ++end.frames;
    on_tick(chains.look(*tick));
  }
  return end;
}

}  // namespace lineservo::apps
