#include "vehicle/floor/motion_track.h"

#include <gtest/gtest.h>

namespace lineservo::vehicle {
namespace {

using namespace std::chrono_literals;

Eigen::Isometry3d pose(double x_m, double turn_rad) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation().x() = x_m;
  X.linear() = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return X;
}

MotionTrack moving() {
  MotionTrack track;
  for (int k = 0; k <= 4; ++k) track.add(k * 1ms, pose(0.1 * k, 1.57 + 0.002 * k));
  return track;
}

TEST(MotionTrack, GoesStraightInBetween) {
  const MotionTrack track = moving();
  EXPECT_TRUE(track.at(2ms).isApprox(pose(0.2, 1.574), 1e-12));
  EXPECT_TRUE(track.at(2500us).isApprox(pose(0.25, 1.575), 1e-9));
  EXPECT_TRUE(track.at(250us).isApprox(pose(0.025, 1.5705), 1e-9));
}

TEST(MotionTrack, BeyondTheEndsTheNearestPoseHolds) {
  const MotionTrack track = moving();
  EXPECT_TRUE(track.at(-5ms).isApprox(pose(0.0, 1.57), 1e-12));
  EXPECT_TRUE(track.at(9ms).isApprox(pose(0.4, 1.578), 1e-12));
  EXPECT_EQ(track.last(), Time(4ms));
}

TEST(MotionTrack, ForgetsOnlyWhatIsNotNeeded) {
  MotionTrack track = moving();
  track.forget_before(2500us);
  EXPECT_TRUE(track.at(2500us).isApprox(pose(0.25, 1.575), 1e-9));
  EXPECT_TRUE(track.at(1ms).isApprox(pose(0.2, 1.574), 1e-12));
}

}  // namespace
}  // namespace lineservo::vehicle
