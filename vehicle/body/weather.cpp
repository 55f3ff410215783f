#include "vehicle/body/weather.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vehicle/body/rigid_body.h"
#include "vehicle/faults.h"

namespace lineservo::vehicle {
namespace {

constexpr double kSlowestPassing_m_s = 1.0;

WeatherParameters valid(const WeatherParameters& parameters) {
  parameters.validate();
  return parameters;
}

}  // namespace

void WeatherParameters::validate() const {
  Faults faults("weather");
  faults.require_not_negative(mean_m_s, "mean_m_s");
  faults.require(std::isfinite(direction_rad), "direction_rad must be finite");
  faults.require_not_negative(turbulence_m_s, "turbulence_m_s");
  faults.require_positive(turbulence_height_m, "turbulence_height_m");
  faults.require(std::isfinite(gust.speed_m_s), "gust speed_m_s must be finite");
  faults.require_not_negative(gust.start_s, "gust start_s");
  faults.require_positive(gust.duration_s, "gust duration_s");
  faults.throw_if_any();
}

double gust_speed_m_s(const GustParameters& gust, double t_s) {
  const double share = (t_s - gust.start_s) / gust.duration_s;
  if (share <= 0.0 || share >= 1.0) return 0.0;
  return 0.5 * gust.speed_m_s * (1.0 - std::cos(2.0 * std::numbers::pi * share));
}

Weather::Weather(const WeatherParameters& parameters, std::uint64_t seed)
    : parameters_(valid(parameters)), mean_(parameters.mean_m_s, parameters.direction_rad) {
  if (parameters.turbulence_m_s == 0.0) return;
  const double passing_m_s = std::max(parameters.mean_m_s, kSlowestPassing_m_s);
  turbulence_.emplace(parameters.turbulence_m_s, parameters.turbulence_height_m, passing_m_s,
                      seconds(kPhysicsStep), seed);
}

Eigen::Vector3d Weather::velocity_W(Time t, const Eigen::Vector3d& p_WB) {
  Eigen::Vector3d v_W = mean_.velocity_W(t, p_WB);
  if (!turbulence_ && parameters_.gust.speed_m_s == 0.0) return v_W;
  bring_to(t);
  Eigen::Vector3d off = turbulence_ ? turbulence_->value() : Eigen::Vector3d(Eigen::Vector3d::Zero());
  off.x() += gust_speed_m_s(parameters_.gust, seconds(t));
  const double c = std::cos(parameters_.direction_rad), s = std::sin(parameters_.direction_rad);
  v_W += Eigen::Vector3d(c * off.x() - s * off.y(), s * off.x() + c * off.y(), off.z());
  return v_W;
}

void Weather::bring_to(Time t) {
  for (; turbulence_ && turbulence_at_ + kPhysicsStep <= t; turbulence_at_ += kPhysicsStep)
    turbulence_->step();
}

}  // namespace lineservo::vehicle
