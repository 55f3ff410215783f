#include <gtest/gtest.h>

#include "servo/law/controllers.h"
#include "tests/apps/flight/test_flight.h"

// The followers of other papers fly the track of lfpf §3.3.4 when nothing disturbs them.

namespace lineservo::apps {
namespace {

using testing::Flown;
using testing::fly;
using testing::request_for;
using testing::story;

class PublishedFollower : public ::testing::TestWithParam<const char*> {};

TEST_P(PublishedFollower, FollowsTheStraightToItsEnd) {
  FlightRequest request = request_for("node:end", "ideal");
  request.layout = "straight";
  request.controller = GetParam();
  const Flown flown = fly(request);
  ASSERT_EQ(flown.summary.outcome, "arrived") << story(flown);
  for (const LegScore& leg : flown.summary.track.legs) EXPECT_LT(leg.settled_rmse_m, 0.02);
}

// Their tilt command is as good as the attitude estimate: without its error they keep to the line.
TEST_P(PublishedFollower, IsAsGoodAsTheAttitudeEstimate) {
  FlightRequest request = request_for("node:end", "paper");
  request.layout = "straight";
  request.controller = GetParam();
  request.settings.speed_m_s = 0.3;
  request.settings.sensors.attitude_sigma_deg = 0.0;
  const Flown flown = fly(request);
  EXPECT_NE(flown.summary.outcome, "lost_line") << story(flown);
  for (const LegScore& leg : flown.summary.track.legs) EXPECT_LT(leg.settled_rmse_m, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Attitude, PublishedFollower,
                         ::testing::Values("grid", "lfpf", "carrot", "improved-carrot"));

}  // namespace
}  // namespace lineservo::apps
