#include "servo/executive/sighting.h"

#include <gtest/gtest.h>

namespace lineservo::servo {
namespace {

using features::kPi;
using features::radians;

PlanStep bend_step(Bend bend = Bend::left) {
  PlanStep step;
  step.expected.bend = bend;
  return step;
}

Observation junction_with(const std::vector<double>& arms_deg) {
  Observation o;
  o.features.junction.emplace();
  for (const double angle_deg : arms_deg) o.features.junction->arms.push_back({radians(angle_deg), 0.3});
  return o;
}

Observation centroid_at(double x_px) {
  Observation o;
  o.features.centroid_px = features::PixelPoint{x_px, 199.5};
  return o;
}

TEST(BendSighting, IsOneArmBackAndOneAheadToASide) {
  const PlanStep step = bend_step();
  EXPECT_EQ(bend_sighting(junction_with({180.0, 45.0}), &step), Bend::left);
  EXPECT_EQ(bend_sighting(junction_with({-40.0, -176.0}), &step), Bend::right);
  EXPECT_EQ(bend_sighting(junction_with({180.0, 90.0}), &step), Bend::none);
  EXPECT_EQ(bend_sighting(junction_with({180.0, 5.0}), &step), Bend::none);
  EXPECT_EQ(bend_sighting(junction_with({180.0, 45.0, 0.0}), &step), Bend::none);
  EXPECT_EQ(bend_sighting(Observation{}, &step), Bend::none);
}

TEST(BendSighting, OnlyWhereThePlanExpectsOne) {
  const PlanStep other;
  EXPECT_EQ(bend_sighting(junction_with({180.0, 45.0}), &other), Bend::none);
  EXPECT_EQ(bend_sighting(junction_with({180.0, 45.0}), nullptr), Bend::none);
}

TEST(BendSighting, WhereABendIsExpectedTheLineDoesNotEnd) {
  Observation o;
  o.features.code.smoothed = features::JunctionCode::straight;
  o.features.code.line_ends_ahead = true;
  const PlanStep bend = bend_step(), other;
  EXPECT_FALSE(near_reading(o, &bend).line_ends_ahead);
  EXPECT_TRUE(near_reading(o, &other).line_ends_ahead);
}

TEST(CentroidBend, IsNoticedWhenTheCentroidLeavesTheMiddle) {
  const PlanStep step = bend_step();
  CentroidBend bend;
  EXPECT_EQ(bend.update(centroid_at(260.0), &step, false), Bend::none);  // not yet been in the middle
  EXPECT_EQ(bend.update(centroid_at(205.0), &step, false), Bend::none);
  EXPECT_EQ(bend.update(centroid_at(244.0), &step, false), Bend::none);
  EXPECT_EQ(bend.update(centroid_at(245.0), &step, false), Bend::right);
  EXPECT_EQ(bend.update(centroid_at(150.0), &step, false), Bend::left);
  EXPECT_EQ(bend.update(centroid_at(150.0), &step, true), Bend::none);  // the node behind
  EXPECT_EQ(bend.update(centroid_at(150.0), &step, false), Bend::none);
}

TEST(NearReading, WhereTheLineIsPursuedNothingButTheDiscCounts) {
  PlanStep step;
  step.pursued = true;
  step.expected.code = features::JunctionCode::start;
  Observation o;
  o.estimate.capture_height_m = 1.0;
  o.features.code.smoothed = features::JunctionCode::corner_left;
  o.features.code.line_ends_ahead = true;
  EXPECT_EQ(near_reading(o, &step).smoothed, features::JunctionCode::straight);
  EXPECT_FALSE(near_reading(o, &step).line_ends_ahead);
  o.features.code.smoothed = features::JunctionCode::start;
  o.features.start_marker = features::LevelPoint{0.1, 0.0};
  EXPECT_EQ(near_reading(o, &step).smoothed, features::JunctionCode::start);
}

}  // namespace
}  // namespace lineservo::servo
