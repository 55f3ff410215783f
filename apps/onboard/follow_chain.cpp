#include "apps/onboard/follow_chain.h"

#include "apps/flight/convert.h"

namespace lineservo::apps {
namespace {

constexpr bool kLands = false;
constexpr double kUnderWay_s = 10.0;  // before the first frame: its command does not ramp up from rest

}  // namespace

FollowChain::FollowChain(const features::CameraParameters& camera, const Settings& settings,
                         const servo::Controller& controller)
    : Chain(camera, settings, controller),
      pilot_(controller.make(settings.laws), controller.traits, executive_options(settings, kLands)) {}

servo::Command FollowChain::decide(const servo::Observation& observation, bool) {
  const servo::Observation& sound = guard_.checked(observation);
  pilot_.see_line(sound);
  const double dt_s = last_tick_ ? servo::seconds(sound.now - *last_tick_) : kUnderWay_s;
  last_tick_ = sound.now;
  servo::Orders orders;
  orders.phase = servo::Phase::follow;
  return pilot_.fly(orders, sound, dt_s);
}

}  // namespace lineservo::apps
