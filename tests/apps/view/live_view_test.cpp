#include "apps/view/live_view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::apps {
namespace {

TEST(PlotSample, WhatIsAbsentIsNotANumber) {
  OverlayScene scene;
  scene.command = servo::LandCommand{};
  const PlotSample sample = sample_of(scene, TickInput{});
  for (const double value : sample.features) EXPECT_TRUE(std::isnan(value));
  for (const std::size_t k : {0u, 1u, 2u}) EXPECT_TRUE(std::isnan(sample.velocities[k])) << k;
  EXPECT_EQ(sample.velocities[3], 0.0);
}

TEST(PlotSample, HasTheFirstLineTheJunctionsDistanceAndTheCommand) {
  OverlayScene scene;
  scene.time_s = 3.5;
  scene.command = servo::VelocityCommand{0.1, -0.02, 0.3, 0.4};
  scene.features.lines.resize(2);
  scene.features.lines.front().rho = 0.2;
  scene.features.lines.front().theta_rad = -0.3;
  scene.features.junction.emplace();
  scene.features.junction->centre = {0.3, -0.4};
  TickInput input;
  input.estimate.capture_height_m = 0.8;
  const PlotSample sample = sample_of(scene, input);
  EXPECT_EQ(sample.time_s, 3.5);
  EXPECT_EQ(sample.features[0], 0.2);
  EXPECT_EQ(sample.features[1], -0.3);
  EXPECT_NEAR(sample.features[2], 0.4, 1e-12);
  EXPECT_EQ(sample.velocities[0], 0.1);
  EXPECT_EQ(sample.velocities[1], -0.02);
  EXPECT_EQ(sample.velocities[2], 0.4);
}

TEST(PlotSample, AnAttitudeHasNoSpeedsButAYawRate) {
  OverlayScene scene;
  scene.command = servo::AttitudeCommand{0.1, 0.2, 0.3, 0.5};
  const PlotSample sample = sample_of(scene, TickInput{});
  EXPECT_TRUE(std::isnan(sample.velocities[0]) && std::isnan(sample.velocities[1]));
  EXPECT_EQ(sample.velocities[2], 0.3);
}

}  // namespace
}  // namespace lineservo::apps
