// Each hardship by itself: it changes the flight, and the flight still gets there.
#include <gtest/gtest.h>

#include "tests/apps/flight/test_flight.h"

namespace lineservo::apps {
namespace {

using testing::Flown;

/// A corner 1.2 m ahead and another 1.2 m to the left.
vehicle::Layout two_corners() {
  vehicle::Layout floor;
  floor.name = "corners";
  floor.nodes = {{"p", {0, 0}}, {"q", {1.2, 0}}, {"r", {1.2, 1.2}}, {"s", {0, 1.2}}};
  for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 3}})
    floor.edges.push_back(
        testing::straight_edge(floor, static_cast<std::size_t>(from), static_cast<std::size_t>(to), 0.1));
  return floor;
}

Flown fly_with(const std::vector<std::string>& settings) {
  FlightRequest request = testing::request_for("node:r", "paper");
  apply_override(request, "camera.frame_rate_hz=30");
  for (const std::string& setting : settings) apply_override(request, setting);
  return testing::fly(request, two_corners(), two_corners());
}

class Hardship : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Hardship, ChangesTheFlightWhichStillArrives) {
  static const std::string kWithout = fly_with({}).summary.trajectory_sha256;
  const Flown flown = fly_with(GetParam());
  EXPECT_EQ(flown.summary.outcome, "arrived") << GetParam().front() << "\n" << testing::story(flown);
  EXPECT_NE(flown.summary.trajectory_sha256, kWithout) << GetParam().front();
  EXPECT_EQ(flown.summary.trajectory_sha256, fly_with(GetParam()).summary.trajectory_sha256);
}

using Settings = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(Weather, Hardship,
                         ::testing::Values(Settings{"wind.mean_m_s=1.5", "wind.direction_spread_deg=180"},
                                           Settings{"wind.turbulence_m_s=0.4"},
                                           Settings{"wind.gust.speed_m_s=1", "wind.gust.start_s=6"},
                                           Settings{"vehicle.mass_factor=1.1"},
                                           Settings{"vehicle.weak_motor.thrust_factor=0.85"},
                                           Settings{"sensors.tilt_bias_deg=0.5"},
                                           Settings{"sensors.velocity_bias_start_m_s=0.03"},
                                           Settings{"sensors.range_sigma_m=0.02"}));
INSTANTIATE_TEST_SUITE_P(Camera, Hardship,
                         ::testing::Values(Settings{"camera.mount_tilt_deg=1"},
                                           Settings{"camera.latency_jitter_s=0.005"},
                                           Settings{"camera.drop_share=0.05"},
                                           Settings{"camera.exposure_s=0.008"},
                                           Settings{"camera.readout_s=0.015"}));
INSTANTIATE_TEST_SUITE_P(Floor, Hardship,
                         ::testing::Values(Settings{"floor.worn_share=0.1"},
                                           Settings{"floor.dirt_share=0.02"},
                                           Settings{"floor.gap_m=0.1", "floor.gap_every_m=0.3"},
                                           Settings{"light.low=0.8", "light.high=1.1"},
                                           Settings{"light.shadow=0.25"}));

}  // namespace
}  // namespace lineservo::apps
