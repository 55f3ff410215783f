#include "apps/onboard/mission_chain.h"

#include "apps/flight/convert.h"

namespace lineservo::apps {
namespace {

const servo::Controller& controller_of(const FlightRequest& request) {
  return servo::find_controller(request.controller);
}

}  // namespace

MissionChain::MissionChain(const FlightRequest& request, const servo::Plan& plan)
    : Chain(camera_parameters(request.settings.camera), request.settings, controller_of(request)),
      executive_(plan,
                 spoilt(controller_of(request).make(request.settings.laws), request.settings.faults.software),
                 controller_of(request).traits, executive_options(request.settings, request.land)) {}

}  // namespace lineservo::apps
