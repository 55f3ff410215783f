#include "vehicle/attitude.h"

#include <gtest/gtest.h>

namespace lineservo::vehicle {
namespace {

TEST(Attitude, AnglesComeBackFromTheQuaternion) {
  for (const double roll : {-0.6, 0.0, 0.3}) {
    for (const double pitch : {-0.4, 0.0, 0.7}) {
      for (const double yaw : {-3.0, 0.0, 2.0}) {
        const RollPitchYaw back = roll_pitch_yaw(quaternion({roll, pitch, yaw}));
        EXPECT_NEAR(back.roll_rad, roll, 1e-12);
        EXPECT_NEAR(back.pitch_rad, pitch, 1e-12);
        EXPECT_NEAR(back.yaw_rad, yaw, 1e-12);
      }
    }
  }
}

TEST(Attitude, PositivePitchIsNoseDownAndPositiveRollIsRightSideDown) {
  EXPECT_LT((tilt_q_HB(0.0, 0.2) * Eigen::Vector3d::UnitX()).z(), 0.0);
  EXPECT_GT((tilt_q_HB(0.2, 0.0) * Eigen::Vector3d::UnitY()).z(), 0.0);
}

TEST(Attitude, RotationAgreesWithTheAxisAndAngleAtSmallAndLargeAngles) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  for (const double angle_rad : {1e-7, 1e-3, 0.5, 3.0}) {
    const Eigen::Quaterniond expected(Eigen::AngleAxisd(angle_rad, axis));
    EXPECT_TRUE(rotation(angle_rad * axis).isApprox(expected, 1e-14)) << angle_rad;
  }
}

TEST(Attitude, EulerRatesAreTheDerivativeOfTheAngles) {
  const RollPitchYaw angles{0.3, -0.4, 1.1};
  const Eigen::Vector3d w_B(0.5, -0.8, 0.9);
  constexpr double kStep_s = 1e-6;
  const RollPitchYaw next = roll_pitch_yaw(quaternion(angles) * rotation(kStep_s * w_B));
  const RollPitchYaw rates = euler_rates(w_B, angles.roll_rad, angles.pitch_rad);
  EXPECT_NEAR(rates.roll_rad, (next.roll_rad - angles.roll_rad) / kStep_s, 1e-5);
  EXPECT_NEAR(rates.pitch_rad, (next.pitch_rad - angles.pitch_rad) / kStep_s, 1e-5);
  EXPECT_NEAR(rates.yaw_rad, (next.yaw_rad - angles.yaw_rad) / kStep_s, 1e-5);
}

TEST(Attitude, TiltIsTheAngleOfTheAxes) {
  EXPECT_NEAR(tilt_rad(quaternion({0.3, 0.0, 2.0})), 0.3, 1e-12);
  EXPECT_NEAR(tilt_rad(quaternion({0.3, 0.4, 0.0})), std::acos(std::cos(0.3) * std::cos(0.4)), 1e-12);
}

}  // namespace
}  // namespace lineservo::vehicle
