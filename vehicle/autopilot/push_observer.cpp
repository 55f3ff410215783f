#include "vehicle/autopilot/push_observer.h"

#include <cmath>

#include "vehicle/attitude.h"
#include "vehicle/autopilot/attitude_controller.h"
#include "vehicle/autopilot/limits.h"

namespace lineservo::vehicle {
namespace {

// What is more than this is a fault, not wind.
constexpr double kGreatestPush_m_s2 = 3.0;

}  // namespace

PushObserver::PushObserver(const Gains& gains, double period_s)
    : drag_per_s_(gains.drag_per_s),
      share_(1.0 - std::exp(-period_s / gains.push_lag_s)),
      lead_(gains.attitude_lag_s / gains.push_lag_s) {}

void PushObserver::update(const Estimate& estimate, double yaw_step_rad) {
  push_H_m_s2_ = turned(push_H_m_s2_, -yaw_step_rad);
  later_H_m_s2_ = turned(later_H_m_s2_, -yaw_step_rad);
  const Eigen::Vector2d seen = estimate.a_H_m_s2 - known_H_m_s2(estimate);
  push_H_m_s2_ = shortened(push_H_m_s2_ + share_ * (seen - push_H_m_s2_), kGreatestPush_m_s2);
  later_H_m_s2_ += share_ * (push_H_m_s2_ - later_H_m_s2_);
}

void PushObserver::forget() {
  push_H_m_s2_.setZero();
  later_H_m_s2_.setZero();
}

// The rate of d̂ is (d̂ − d̂_later)/τ_d.
Eigen::Vector2d PushObserver::led_push_H_m_s2() const {
  return push_H_m_s2_ + lead_ * (push_H_m_s2_ - later_H_m_s2_);
}

Eigen::Vector2d PushObserver::acceleration_H_m_s2(const Estimate& estimate) const {
  return known_H_m_s2(estimate) + push_H_m_s2_;
}

Eigen::Vector2d PushObserver::known_H_m_s2(const Estimate& estimate) const {
  return acceleration_of({estimate.roll_rad, estimate.pitch_rad}) - drag_per_s_ * estimate.v_H_m_s.head<2>();
}

}  // namespace lineservo::vehicle
