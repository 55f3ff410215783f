#include "apps/overlay/flight_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/flight/convert.h"
#include "apps/overlay/frame_projection.h"
#include "tests/apps/flight/test_flight.h"

namespace lineservo::apps {
namespace {

bool is_paint(const cv::Mat& bgr, cv::Point2d at) {
  const cv::Vec3b pixel = bgr.at<cv::Vec3b>(static_cast<int>(at.y), static_cast<int>(at.x));
  return pixel[1] > pixel[0] + 80 || pixel[2] > pixel[0] + 80;
}

bool is_inside(const cv::Mat& bgr, cv::Point2d at) {
  return at.x > 20.0 && at.y > 20.0 && at.x < bgr.cols - 20.0 && at.y < bgr.rows - 20.0;
}

// In wind, so that the camera tilts.
TEST(FlightScene, WhatIsSeenLiesOnThePaintOfTheFrame) {
  FlightRequest request = testing::request_for("a13", "paper");
  request.layout = "tape-warehouse";  // narrow lines
  apply_override(request, "wind.mean_m_s=2");
  apply_override(request, "speed_m_s=0.5");
  apply_override(request, "time_limit_s=14");
  const Mission mission = prepare(request);
  const features::CameraModel camera(camera_parameters(request.settings.camera));
  Flight flight(mission.request, mission.floor, mission.plan);
  int lines = 0, junctions = 0;
  double steepest_rad = 0.0;
  flight.listen([&](const FlightTick& tick) {
    const OverlayScene scene = scene_of(tick);
    if (scene.phase != "follow" || !scene.bgr) return;
    steepest_rad = std::max(steepest_rad, std::hypot(tick.input.roll_rad, tick.input.pitch_rad));
    const FrameProjection projection(camera, scene.view, 1);
    if (const features::LineFeature* line = scene.features.line()) {
      const Eigen::Vector2d middle = 0.5 * (line->begin.vector() + line->end.vector());
      EXPECT_TRUE(is_paint(*scene.bgr, *projection.at({middle.x(), middle.y()}))) << scene.time_s;
      ++lines;
    }
    if (!scene.features.junction) return;
    const auto centre = projection.at(scene.features.junction->centre);
    if (!centre || !is_inside(*scene.bgr, *centre)) return;
    EXPECT_TRUE(is_paint(*scene.bgr, *centre)) << scene.time_s;
    ++junctions;
  });
  while (flight.step()) {
  }
  EXPECT_GT(lines, 20);
  EXPECT_GT(junctions, 5);
  EXPECT_GT(steepest_rad, 0.03);
}

TEST(FlightScene, TellsThePhaseTheNextNodeAndTheTruePlace) {
  FlightRequest request = testing::request_for("a13", "ideal");
  apply_override(request, "time_limit_s=1");
  const Mission mission = prepare(request);
  Flight flight(mission.request, mission.floor, mission.plan);
  std::optional<OverlayScene> first;
  flight.listen([&](const FlightTick& tick) {
    if (!first) first = scene_of(tick);
  });
  while (flight.step()) {
  }
  ASSERT_TRUE(first && first->vehicle);
  EXPECT_EQ(first->phase, "take-off");
  ASSERT_TRUE(first->next);
  EXPECT_EQ(*first->next, mission.plan.steps.front().expected);
  EXPECT_LT((first->vehicle->p_W - Eigen::Vector2d(0.6, 0.6)).norm(), 0.1);
  EXPECT_NEAR(first->vehicle->heading_rad, 0.0, 0.2);
}

}  // namespace
}  // namespace lineservo::apps
