#include "apps/onboard/follow_chain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/flight/convert.h"
#include "tests/apps/flight/test_flight.h"

namespace lineservo::apps {
namespace {

using servo::Phase;

/// A flight and beside it, on the same frames and estimates, a chain without a plan: the largest difference
/// of their commands while the flight has followed an edge for a while and nothing makes it brake.
TEST(FollowChain, SaysWhatAFlightSaysThatFollowsAnEdge) {
  const FlightRequest request = testing::request_for("a03", "paper");
  const Mission mission = prepare(request);
  FollowChain chain(camera_parameters(request.settings.camera), request.settings,
                    servo::find_controller(request.controller));
  Flight flight(mission.request, mission.floor, mission.plan);
  double largest = 0.0;
  int compared = 0;
  flight.listen([&](const FlightTick& tick) {
    const servo::Command own =
        chain.command(tick.input, tick.bgr ? chain.see(tick.input, *tick.bgr) : features::FrameFeatures{});
    const double t_s = servo::seconds(tick.input.now);
    if (t_s < 15.0 || t_s > 20.0) return;
    const auto& a = std::get<servo::VelocityCommand>(own);
    const auto& b = std::get<servo::VelocityCommand>(tick.command);
    largest = std::max({largest, std::abs(a.forward_m_s - b.forward_m_s), std::abs(a.left_m_s - b.left_m_s),
                        std::abs(a.up_m_s - b.up_m_s), std::abs(a.yaw_rate_rad_s - b.yaw_rate_rad_s)});
    ++compared;
  });
  while (flight.step() && compared < 50) {
  }
  EXPECT_EQ(compared, 50);
  EXPECT_LT(largest, 1e-3);
}

}  // namespace
}  // namespace lineservo::apps
