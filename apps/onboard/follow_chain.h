#pragma once

#include <optional>

#include "apps/onboard/chain.h"
#include "servo/executive/observation_guard.h"
#include "servo/executive/pilot.h"

namespace lineservo::apps {

/// A chain without a plan: the vehicle is under way and follows whatever line it sees, past every junction.
/// Its commands are those of a flight that follows an edge with no stop in view.
class FollowChain final : public Chain {
 public:
  /// Throws std::invalid_argument.
  FollowChain(const features::CameraParameters& camera, const Settings& settings,
              const servo::Controller& controller);

 private:
  bool on_the_way() const override { return true; }
  servo::Command decide(const servo::Observation& observation, bool on_ground) override;

  servo::ObservationGuard guard_;
  servo::Pilot pilot_;
  std::optional<servo::Time> last_tick_;
};

}  // namespace lineservo::apps
