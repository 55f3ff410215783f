#include "servo/executive/turn.h"

#include <gtest/gtest.h>

namespace lineservo::servo {
namespace {

using features::kPi;
using features::radians;

/// A frame taken at a heading, now passed by `since_rad`, that shows a line at an angle.
Observation view(double yaw_rad, double line_angle_rad, double since_rad = 0.0) {
  Observation o;
  o.estimate.odometry_at_capture.yaw_rad = yaw_rad;
  o.estimate.odometry_now.yaw_rad = yaw_rad + since_rad;
  features::LineFeature line;
  line.theta_rad = line_angle_rad;
  o.features.lines.push_back(line);
  return o;
}

TEST(Turn, GoesByTheGyroWhileTheNextEdgeIsFar) {
  Turn turn(0.1, kPi / 2);
  EXPECT_FALSE(turn.correct(view(0.1, 0.0)));
  EXPECT_NEAR(turn.left_rad(view(0.3, 0.0)), kPi / 2 - 0.2, 1e-12);
}

TEST(Turn, EndsOnTheLineThatIsSeenNearTheEnd) {
  Turn turn(0.0, kPi / 2);
  const Observation o = view(radians(80.0), radians(-7.0), radians(2.0));  // the edge lies at 87°
  const auto angle_rad = turn.correct(o);
  ASSERT_TRUE(angle_rad);
  EXPECT_NEAR(turn.heading_out_rad(), radians(87.0), 1e-12);
  EXPECT_NEAR(turn.left_rad(o), radians(5.0), 1e-12);
  EXPECT_NEAR(*angle_rad, radians(-5.0), 1e-12);
  EXPECT_EQ(turn.heading_in_rad(), 0.0);
}

TEST(Turn, ALineAcrossIsNotTheNextEdge) {
  Turn turn(0.0, -kPi / 2);
  EXPECT_FALSE(turn.correct(view(radians(-85.0), radians(60.0))));
  EXPECT_NEAR(turn.heading_out_rad(), -kPi / 2, 1e-12);
}

}  // namespace
}  // namespace lineservo::servo
