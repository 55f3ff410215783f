#pragma once

#include "apps/config/flight_request.h"
#include "apps/onboard/chain.h"
#include "servo/executive/executive.h"

namespace lineservo::apps {

/// The chain of a flight: the executive carries out a plan.
class MissionChain final : public Chain {
 public:
  /// With the request's controller and its settings' camera. Throws std::invalid_argument.
  MissionChain(const FlightRequest& request, const servo::Plan& plan);

  const servo::Executive& executive() const { return executive_; }
  std::vector<servo::ExecutiveEvent> take_events() { return executive_.take_events(); }

 private:
  bool on_the_way() const override { return executive_.phase() == servo::Phase::follow; }
  servo::Command decide(const servo::Observation& observation, bool on_ground) override {
    return executive_.tick(observation, on_ground);
  }

  servo::Executive executive_;
};

}  // namespace lineservo::apps
