#pragma once

#include "vehicle/autopilot/gains.h"
#include "vehicle/autopilot/options.h"
#include "vehicle/autopilot/push_observer.h"
#include "vehicle/autopilot/reference_axis.h"
#include "vehicle/estimate.h"

namespace lineservo::vehicle {

/// Horizontal velocity in the heading frame → horizontal acceleration: reference model, its velocity and
/// acceleration held, drag and what pushes from outside made up for.
class HorizontalController {
 public:
  HorizontalController(const Gains& gains, const AutopilotOptions& options, double period_s);

  /// `yaw_rate_rad_s` is how fast the frame turns.
  Eigen::Vector2d acceleration_H(const Eigen::Vector2d& v_set_H, const Estimate& estimate,
                                 double yaw_rate_rad_s);
  /// Start from this velocity. What was learnt about the wind stays.
  void start_from(const Eigen::Vector2d& v_H);
  void forget();

 private:
  Gains gains_;
  double period_s_, greatest_m_s2_;
  ReferenceAxis x_, y_;
  PushObserver push_;
};

/// Climb rate → vertical acceleration: reference model and PI.
class VerticalController {
 public:
  VerticalController(const Gains& gains, const AutopilotOptions& options, double period_s);

  double acceleration(double climb_rate_set_m_s, const Estimate& estimate);
  void forget();

 private:
  Gains gains_;
  double period_s_;
  ReferenceAxis z_;
  double integral_m_s2_ = 0.0;
};

}  // namespace lineservo::vehicle
