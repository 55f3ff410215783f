// Whatever features a flight is set to: it passes a T, turns, and stops on a cross, on broad lines and on
// tape.
#include <gtest/gtest.h>

#include "features/detect/segmenters.h"
#include "features/line/line_methods.h"
#include "tests/apps/flight/test_flight.h"

namespace lineservo::apps {
namespace {

using testing::Flown;
using testing::fly;
using testing::request_for;

constexpr double kBroad_m = 0.36, kTape_m = 0.05;

/// From a red disc on an L corner to a T to the left 1.6 m ahead, and from there to a cross.
vehicle::Layout aisle(double width_m) {
  vehicle::Layout floor;
  floor.name = "aisle";
  floor.nodes = {{"start", {0, 0}},    {"tee", {1.6, 0}},   {"ahead", {3, 0}},  {"cross", {1.6, 1.6}},
                 {"left", {0.4, 1.6}}, {"right", {3, 1.6}}, {"up", {1.6, 2.8}}, {"behind", {0, 1.0}}};
  for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {1, 3}, {3, 4}, {3, 5}, {3, 6}, {0, 7}})
    floor.edges.push_back(
        testing::straight_edge(floor, static_cast<std::size_t>(from), static_cast<std::size_t>(to), width_m));
  floor.start_markers.push_back({floor.nodes[0].p_W, 0.18});
  return floor;
}

Flown fly_over(double width_m, const std::vector<std::string>& settings) {
  FlightRequest request = request_for("node:cross", "paper");
  for (const std::string& setting : settings) apply_override(request, setting);
  return fly(request, aisle(width_m), aisle(width_m));
}

void expect_arrival(double width_m, const std::vector<std::string>& settings) {
  const Flown flown = fly_over(width_m, settings);
  ASSERT_EQ(flown.summary.outcome, "arrived") << settings.front() << " at " << width_m << "\n"
                                              << testing::story(flown);
  EXPECT_LT(flown.summary.rest->target_error_m, 0.05) << settings.front() << " at " << width_m;
}

class OnEveryWidth : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Floors, OnEveryWidth, ::testing::Values(kBroad_m, kTape_m),
                         [](const auto& width) { return width.param == kBroad_m ? "Broad" : "Tape"; });

TEST_P(OnEveryWidth, EveryLineMethodArrives) {
  for (const features::LineMethod& method : features::line_methods())
    expect_arrival(GetParam(), {"features.line.method=" + std::string(method.name)});
}

TEST_P(OnEveryWidth, EverySegmenterForYellowArrives) {
  for (const std::string name : {"hsv", "svm", "auto"})
    expect_arrival(GetParam(), {"features.segmenter=" + name});
}

// The published erosion leaves 12 of the 20 px of tape, which is no arm of a junction any more.
TEST_P(OnEveryWidth, TheChannelDifferenceArrivesWithoutItsErosion) {
  expect_arrival(GetParam(), {"features.segmenter=difference", "features.difference.erosion_px=1"});
}

TEST_P(OnEveryWidth, TheTrackedLineArrives) {
  expect_arrival(GetParam(), {"features.line.filter=kalman"});
}

// The apparent sway is nothing that the fast observer of the drift may take for wind.
TEST_P(OnEveryWidth, ArrivesWithoutTiltCorrection) {
  expect_arrival(GetParam(), {"features.tilt_correction=false", "servo.ibvs.drift_time_constant_s=1",
                              "servo.dock.drift_time_constant_s=1"});
}

// Against a wind from the side the vehicle leans, and without the correction flies beside the line.
TEST_P(OnEveryWidth, TiltCorrectionKeepsALeaningVehicleOnTheLine) {
  const auto rmse_m = [](const std::string& correction) {
    const Flown flown = fly_over(GetParam(), {"wind.mean_m_s=1.5", "wind.direction_deg=90", correction});
    return flown.summary.track.legs.front().whole.rmse_m;
  };
  EXPECT_GT(rmse_m("features.tilt_correction=false"), 3.0 * rmse_m("features.tilt_correction=true"));
}

TEST(FeaturesInFlight, PublishedDensitiesArriveOnBroadLines) {
  expect_arrival(kBroad_m, {"features.junction.method=fpd"});
}

}  // namespace
}  // namespace lineservo::apps
