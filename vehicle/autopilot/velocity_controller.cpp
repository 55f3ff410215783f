#include "vehicle/autopilot/velocity_controller.h"

#include <algorithm>
#include <cmath>

#include "vehicle/autopilot/limits.h"

namespace lineservo::vehicle {
namespace {

// The integral makes up for mass and worn motors: more than this is a fault, not a disturbance.
constexpr double kGreatestIntegral_m_s2 = 3.0;

ReferenceAxis::Answer horizontal_answer(const Gains& gains, const AutopilotOptions& options) {
  return {gains.attitude_lag_s, gains.velocity_bandwidth_per_s, 0.85, options.horizontal_acceleration_m_s2};
}

ReferenceAxis::Answer vertical_answer(const Gains& gains, const AutopilotOptions& options) {
  return {gains.rotor_lag_s, gains.climb_bandwidth_per_s, 1.0, options.vertical_acceleration_m_s2};
}

}  // namespace

HorizontalController::HorizontalController(const Gains& gains, const AutopilotOptions& options,
                                           double period_s)
    : gains_(gains),
      period_s_(period_s),
      greatest_m_s2_(kGravity_m_s2 * std::tan(options.limits.max_tilt_rad)),
      x_(horizontal_answer(gains, options), period_s),
      y_(horizontal_answer(gains, options), period_s),
      push_(gains, period_s) {}

// a = a_c + k_v (v_r − v) + k_a (a_r − a) + k_d v_r − d̂, where a_c is the model's command, to which belongs
// ψ̇ × v_r in a frame that turns.
Eigen::Vector2d HorizontalController::acceleration_H(const Eigen::Vector2d& v_set_H, const Estimate& estimate,
                                                     double yaw_rate_rad_s) {
  push_.update(estimate, yaw_rate_rad_s * period_s_);
  const Eigen::Vector2d a_command(x_.step(v_set_H.x()), y_.step(v_set_H.y()));
  const Eigen::Vector2d a_model(x_.acceleration_m_s2(), y_.acceleration_m_s2());
  const Eigen::Vector2d v_model(x_.velocity_m_s(), y_.velocity_m_s());
  const Eigen::Vector2d a_turning = yaw_rate_rad_s * Eigen::Vector2d(-v_model.y(), v_model.x());
  const Eigen::Vector2d v_error = v_model - estimate.v_H_m_s.head<2>();
  const Eigen::Vector2d a_error = a_model + a_turning - push_.acceleration_H_m_s2(estimate);
  const Eigen::Vector2d wanted = a_command + a_turning + gains_.velocity_per_s * v_error +
                                 gains_.acceleration_gain * a_error + gains_.drag_per_s * v_model -
                                 push_.led_push_H_m_s2();
  return shortened(wanted, greatest_m_s2_);
}

void HorizontalController::start_from(const Eigen::Vector2d& v_H) {
  x_.reset(v_H.x());
  y_.reset(v_H.y());
}

void HorizontalController::forget() {
  start_from(Eigen::Vector2d::Zero());
  push_.forget();
}

VerticalController::VerticalController(const Gains& gains, const AutopilotOptions& options, double period_s)
    : gains_(gains), period_s_(period_s), z_(vertical_answer(gains, options), period_s) {}

double VerticalController::acceleration(double climb_rate_set_m_s, const Estimate& estimate) {
  const double a_model = z_.step(climb_rate_set_m_s);
  const double error = z_.velocity_m_s() - estimate.v_H_m_s.z();
  integral_m_s2_ = std::clamp(integral_m_s2_ + period_s_ * gains_.climb_integral_per_s2 * error,
                              -kGreatestIntegral_m_s2, kGreatestIntegral_m_s2);
  return a_model + gains_.climb_per_s * error + integral_m_s2_;
}

void VerticalController::forget() {
  z_.reset(0.0);
  integral_m_s2_ = 0.0;
}

}  // namespace lineservo::vehicle
