#pragma once

#include <Eigen/Core>

#include "vehicle/autopilot/gains.h"
#include "vehicle/estimate.h"

namespace lineservo::vehicle {

/// What pushes the vehicle sideways besides its tilt and its drag in still air: wind above all. The
/// accelerometer tells it at once, the velocity would tell it late:
///   d = a − a_tilt + k_d v,    d̂ = d / (τ_d s + 1),    d̂_led = d̂ + τ_tilt d̂˙,  d̂˙ = s d̂ / (τ_d s + 1)
/// (wind_rejection.md). The estimate's acceleration has no bias on the long run, so neither has d̂.
class PushObserver {
 public:
  PushObserver(const Gains& gains, double period_s);

  /// `yaw_step_rad`: how far the frame has turned since the last call; the wind stays where it is.
  void update(const Estimate& estimate, double yaw_step_rad);
  void forget();

  /// d̂ in the heading frame.
  const Eigen::Vector2d& push_H_m_s2() const { return push_H_m_s2_; }
  /// d̂_led: what to tilt against now, so that the tilt's lag does not show.
  Eigen::Vector2d led_push_H_m_s2() const;
  /// The acceleration that tilt, drag and push amount to: smoother than the estimate's own.
  Eigen::Vector2d acceleration_H_m_s2(const Estimate& estimate) const;

 private:
  Eigen::Vector2d known_H_m_s2(const Estimate& estimate) const;

  double drag_per_s_, share_, lead_;
  Eigen::Vector2d push_H_m_s2_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d later_H_m_s2_ = Eigen::Vector2d::Zero();  ///< d̂ one lag later
};

}  // namespace lineservo::vehicle
