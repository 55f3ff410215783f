#include "apps/watch/estimates_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"
#include "vehicle/time.h"

namespace lineservo::apps {
namespace {

using ::testing::HasSubstr;
using vehicle::from_seconds;

class EstimatesFile : public ::testing::Test {
 protected:
  Estimates read(const std::string& text) const { return read_estimates(temp_.write("e.csv", text)); }
  std::string complaint(const std::string& text) const {
    return testing::complaint([&] { read(text); });
  }
  const testing::TempFolder temp_;
};

TEST_F(EstimatesFile, IsInterpolatedLinearly) {
  const Estimates estimates = read("t_s,roll_rad,height_m\n1,0.1,0.5\n3,0.3,0.9\n");
  EXPECT_EQ(estimates.at(from_seconds(1.0)).height_m, 0.5);
  EXPECT_EQ(estimates.at(from_seconds(3.0)).height_m, 0.9);
  EXPECT_NEAR(estimates.at(from_seconds(1.5)).height_m, 0.6, 1e-12);
  EXPECT_NEAR(estimates.at(from_seconds(1.5)).roll_rad, 0.15, 1e-12);
  EXPECT_EQ(estimates.at(from_seconds(1.5)).pitch_rad, 0.0);
}

// Forward by 0.2 m/s for 2 s while facing the left of the first heading.
TEST_F(EstimatesFile, VelocityAndYawAreIntegratedToTheOdometry) {
  const Estimates estimates = read(
      "t_s,height_m,yaw_rad,forward_m_s\r\n0,0.5,1.5707963267948966,0.2\r\n"
      "1,0.5,1.5707963267948966,0.2\r\n2,0.5,1.5707963267948966,0.2\r\n");
  const EstimateAt e = estimates.at(from_seconds(1.5));
  EXPECT_NEAR(e.odometry.translation_m.x(), 0.0, 1e-12);
  EXPECT_NEAR(e.odometry.translation_m.y(), 0.3, 1e-12);
  EXPECT_NEAR(e.v_H_m_s.x(), 0.2, 1e-12);
}

TEST_F(EstimatesFile, AFrameOutsideItsTimesIsTold) {
  const Estimates estimates = read("t_s,height_m\n1,0.5\n3,0.9\n");
  for (const double t_s : {0.9, 3.1})
    EXPECT_THAT(testing::complaint([&] { estimates.at(from_seconds(t_s)); }),
                HasSubstr("e.csv: holds 1.000 to 3.000 s; there is a frame at"));
}

TEST_F(EstimatesFile, WhatIsNoneIsRefusedWithItsLine) {
  EXPECT_THAT(complaint(""), HasSubstr("e.csv: must have a header and at least one row"));
  EXPECT_THAT(complaint("t_s,up_m_s\n1,1\n"), HasSubstr("e.csv:1: the header must name t_s and height_m"));
  EXPECT_THAT(complaint("t_s,height_m\n0,0.5\n1\n"), HasSubstr("e.csv:3: height_m '' must be a number"));
  EXPECT_THAT(complaint("t_s,height_m\n0,0\n"),
              HasSubstr("e.csv:2: height_m '0' must be a number from 0.05"));
  EXPECT_THAT(complaint("t_s,height_m\n0,nan\n"), HasSubstr("e.csv:2: height_m 'nan'"));
  EXPECT_THAT(complaint("t_s,height_m\n-1,1\n"), HasSubstr("e.csv:2: t_s '-1'"));
  EXPECT_THAT(complaint("t_s,height_m\n1,1\n1,1\n"), HasSubstr("e.csv:3: t_s must be greater"));
  EXPECT_THAT(complaint("t_s,height_m\n1,1,1\n"), HasSubstr("e.csv:2: has more columns than its header"));
  EXPECT_THAT(testing::complaint([&] { read_estimates(temp_.path() / "none.csv"); }),
              HasSubstr("none.csv: not a file"));
}

// A column whose name is mistyped would count as not known, and its zeros be taken for what was measured.
TEST_F(EstimatesFile, ColumnsThatAreNoneOrThereTwiceAreRefused) {
  EXPECT_THAT(complaint("t_s,height_m,roll_deg\n1,1,1\n"),
              HasSubstr("e.csv:1: unknown column 'roll_deg'; allowed: t_s, height_m, roll_rad, pitch_rad, "
                        "yaw_rad, forward_m_s, left_m_s, up_m_s"));
  EXPECT_THAT(complaint("t_s, height_m\n1,1\n"), HasSubstr("unknown column ' height_m'"));
  EXPECT_THAT(complaint("t_s,height_m,t_s\n1,1,2\n"), HasSubstr("e.csv:1: column 't_s' is there twice"));
}

TEST_F(EstimatesFile, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBFt_s,height_m\r\n1,0.5\r\n").at(from_seconds(1.0)).height_m, 0.5);
}

}  // namespace
}  // namespace lineservo::apps
