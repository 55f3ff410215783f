#include "vehicle/estimator/estimate_history.h"

#include <gtest/gtest.h>

namespace lineservo::vehicle {
namespace {

/// Every field goes on linearly with time, the yaw past π.
Estimate at_tick(int tick) {
  Estimate e;
  e.stamp = tick * kInertialPeriod;
  e.yaw_rad = 3.0 + 0.01 * tick;
  e.roll_rad = 1e-3 * tick;
  e.v_H_m_s << 0.1 * tick, 0.0, -0.1 * tick;
  e.a_H_m_s2 << 0.0, 0.2 * tick;
  e.height_m = 0.5 + 0.001 * tick;
  return e;
}

EstimateHistory two_seconds() {
  EstimateHistory history;
  for (int tick = 0; tick <= 400; ++tick) history.add(at_tick(tick));
  return history;
}

TEST(EstimateHistory, InterpolatesEveryFieldBetweenTwoTicks) {
  const Estimate e = two_seconds().at(Time(300 * kInertialPeriod) + std::chrono::microseconds(1250));
  EXPECT_NEAR(e.yaw_rad, 3.0 + 3.0025, 1e-12);
  EXPECT_NEAR(e.roll_rad, 0.30025, 1e-12);
  EXPECT_NEAR(e.v_H_m_s.z(), -30.025, 1e-12);
  EXPECT_NEAR(e.a_H_m_s2.y(), 60.05, 1e-12);
  EXPECT_NEAR(e.height_m, 0.80025, 1e-12);
  EXPECT_EQ(e.stamp, Time(300 * kInertialPeriod) + std::chrono::microseconds(1250));
}

TEST(EstimateHistory, KeepsOneSecondAndAnswersBeyondWithTheNearest) {
  const EstimateHistory history = two_seconds();
  EXPECT_EQ(history.at(std::chrono::seconds(1)).stamp, Time(std::chrono::seconds(1)));
  EXPECT_EQ(history.at(Time(0)).stamp, Time(std::chrono::seconds(1)));
  EXPECT_EQ(history.at(std::chrono::seconds(9)).stamp, Time(std::chrono::seconds(2)));
}

TEST(EstimateHistory, AYoungHistoryAnswersWithItsFirst) {
  EstimateHistory history;
  history.add(at_tick(3));
  EXPECT_EQ(history.at(Time(0)).stamp, Time(3 * kInertialPeriod));
}

}  // namespace
}  // namespace lineservo::vehicle
