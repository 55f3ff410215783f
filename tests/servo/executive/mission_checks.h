#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "servo/executive/executive.h"
#include "tests/servo/test_mission.h"

namespace lineservo::servo::testing {

using features::radians;

inline Plan plan_to(const TestFloor& floor, const std::string& target) {
  const Topology topology = floor.topology();
  return compile(topology, find_target(topology, target), target);
}

/// A mission over a floor, from a start that is as far off as data/README.md allows.
inline Mission mission_to(const TestFloor& floor, const std::string& target, double speed_m_s = 0.3) {
  const Plan plan = plan_to(floor, target);
  Pose start{floor.at(floor.names().front()), plan.start_heading_rad + radians(5.0), 0.0};
  start.p_W += Eigen::Vector2d(-0.07, 0.07);
  Mission mission(floor, plan, start);
  mission.options.speed_m_s = speed_m_s;
  return mission;
}

inline double distance_m(const Logbook& log, const Eigen::Vector2d& p_W) {
  return (log.pose.p_W - p_W).norm();
}

/// What holds in every flight: finite commands that change no faster than the limits allow.
inline void expect_smooth(const Logbook& log, const CommandLimits& limits = {}) {
  constexpr double kSlack = 1e-9;
  for (std::size_t k = 1; k < log.ticks.size(); ++k) {
    EXPECT_TRUE(is_finite(log.ticks[k].command));
    const auto* from = std::get_if<VelocityCommand>(&log.ticks[k - 1].command);
    const auto* to = std::get_if<VelocityCommand>(&log.ticks[k].command);
    if (!from || !to) continue;
    const double dt_s = log.ticks[k].t_s - log.ticks[k - 1].t_s;
    const double horizontal = std::hypot(to->forward_m_s - from->forward_m_s, to->left_m_s - from->left_m_s);
    ASSERT_LE(horizontal, limits.acceleration_m_s2 * dt_s + kSlack) << "at " << log.ticks[k].t_s << " s";
    ASSERT_LE(std::abs(to->up_m_s - from->up_m_s), limits.acceleration_m_s2 * dt_s + kSlack);
    ASSERT_LE(std::abs(to->yaw_rate_rad_s - from->yaw_rate_rad_s),
              limits.yaw_acceleration_rad_s2 * dt_s + kSlack);
    ASSERT_LE(std::hypot(to->forward_m_s, to->left_m_s), limits.horizontal_m_s + kSlack);
  }
}

inline void expect_arrival(const Logbook& log, const Eigen::Vector2d& node_W, double bound_m) {
  EXPECT_EQ(log.end, Phase::finished);
  EXPECT_EQ(log.reason, AbortReason::none);
  EXPECT_LT(distance_m(log, node_W), bound_m);
  expect_smooth(log);
}

}  // namespace lineservo::servo::testing
