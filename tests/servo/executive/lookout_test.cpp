#include "servo/executive/lookout.h"

#include <gtest/gtest.h>

#include "features/geometry/angles.h"

namespace lineservo::servo {
namespace {

using features::radians;

/// A frame taken at a heading, over a node whose arms lie at these headings.
Observation frame(double heading_rad, const std::vector<double>& arms_rad, double off = 0.0) {
  Observation o;
  o.estimate.odometry_at_capture.yaw_rad = heading_rad;
  o.features.junction.emplace();
  o.features.junction->centre = {off, 0.0};
  for (const double arm_rad : arms_rad)
    o.features.junction->arms.push_back({features::wrap_angle(arm_rad - heading_rad), 0.3});
  return o;
}

TEST(Lookout, ArmsAreToldAgainstTheHeadingOfArrival) {
  const double arrival_rad = 0.7;
  Lookout lookout(arrival_rad);
  for (int k = 0; k < 36; ++k) {
    const double noise_rad = radians(k % 2 == 0 ? 2.0 : -2.0);
    const double turned_rad = radians(10.0 * k);
    lookout.observe(frame(arrival_rad + turned_rad, {arrival_rad + noise_rad, arrival_rad + radians(60.0),
                                                     arrival_rad + radians(-120.0)}));
  }
  EXPECT_EQ(lookout.told(), "junction with arms at -120°, 0°, 60°");
}

TEST(Lookout, WhatFewFramesShowIsNoArm) {
  Lookout lookout(0.0);
  for (int k = 0; k < 10; ++k) lookout.observe(frame(0.0, {0.0}));
  for (int k = 0; k < 3; ++k) lookout.observe(frame(0.0, {0.0, 1.0}));
  ASSERT_EQ(lookout.arms_rad().size(), 1u);
  EXPECT_NEAR(lookout.arms_rad()[0], 0.0, 1e-9);
}

TEST(Lookout, AnotherNodeAsideDoesNotCount) {
  Lookout lookout(0.0);
  lookout.observe(frame(0.0, {0.0, 1.5}, 0.6));
  EXPECT_EQ(lookout.told(), "no junction");
}

TEST(Lookout, ADiscIsTold) {
  Lookout lookout(0.0);
  Observation o;
  o.features.start_marker = features::LevelPoint{0.0, 0.0};
  lookout.observe(o);
  EXPECT_EQ(lookout.told(), "no junction; red disc");
}

}  // namespace
}  // namespace lineservo::servo
