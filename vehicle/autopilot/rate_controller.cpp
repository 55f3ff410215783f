#include "vehicle/autopilot/rate_controller.h"

#include <Eigen/Geometry>

namespace lineservo::vehicle {
namespace {
constexpr double kGreatestIntegral_rad_s2 = 10.0;
}

RateController::RateController(const AirframeParameters& airframe, const Gains& gains, double period_s)
    : inertia_kg_m2_(airframe.inertia_kg_m2), gains_(gains), period_s_(period_s) {}

Eigen::Vector3d RateController::torque_B(const Eigen::Vector3d& w_set_B, const Eigen::Vector3d& w_dot_set_B,
                                         const Eigen::Vector3d& w_B) {
  error_ = w_set_B - w_B;
  const Eigen::Vector3d w_dot_B = gains_.rate_per_s * error_ + integral_rad_s2_ + w_dot_set_B;
  return inertia_kg_m2_.cwiseProduct(w_dot_B) + w_B.cross(inertia_kg_m2_.cwiseProduct(w_B));
}

void RateController::integrate(const Eigen::Array3d& share_of_axes) {
  const Eigen::Vector3d step = period_s_ * gains_.rate_integral_per_s2 * error_;
  integral_rad_s2_ += (share_of_axes * step.array()).matrix();
  integral_rad_s2_ = integral_rad_s2_.cwiseMax(-kGreatestIntegral_rad_s2).cwiseMin(kGreatestIntegral_rad_s2);
}

void RateController::forget() {
  error_.setZero();
  integral_rad_s2_.setZero();
}

}  // namespace lineservo::vehicle
