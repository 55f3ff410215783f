#include "apps/watch/estimates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"
#include "vehicle/time.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using vehicle::from_seconds;

TEST(Estimates, AHeightIsTheSameAtEveryTime) {
  const Estimates estimates(0.7);
  for (const double t_s : {0.0, 1.0, 1e6}) {
    EXPECT_EQ(estimates.at(from_seconds(t_s)).height_m, 0.7);
    EXPECT_EQ(estimates.at(from_seconds(t_s)).roll_rad, 0.0);
    EXPECT_TRUE(estimates.at(from_seconds(t_s)).odometry.translation_m.isZero());
  }
}

TEST(Estimates, AreInterpolatedBetweenRowsAndToldOutside) {
  EstimateAt first, last;
  first.t = from_seconds(1.0);
  last.t = from_seconds(3.0);
  last.height_m = 0.9;
  last.pitch_rad = 0.2;
  last.v_H_m_s = {0.4, -0.4, 0.0};
  last.odometry = {{2.0, 4.0}, 1.0};
  const Estimates estimates({first, last}, "e");
  const EstimateAt e = estimates.at(from_seconds(1.5));
  EXPECT_NEAR(e.height_m, 0.6, 1e-12);
  EXPECT_NEAR(e.pitch_rad, 0.05, 1e-12);
  EXPECT_NEAR((e.v_H_m_s - Eigen::Vector3d(0.1, -0.1, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((e.odometry.translation_m - Eigen::Vector2d(0.5, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(e.odometry.yaw_rad, 0.25, 1e-12);
  EXPECT_EQ(estimates.at(last.t).height_m, 0.9);
  EXPECT_THAT(testing::complaint([&] { estimates.at(from_seconds(3.5)); }), HasSubstr("e: holds 1.000 to"));
}

}  // namespace
}  // namespace lineservo::apps
