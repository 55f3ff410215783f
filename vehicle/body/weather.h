#pragma once

#include <optional>

#include "vehicle/body/turbulence.h"
#include "vehicle/body/wind.h"

namespace lineservo::vehicle {

/// A gust as MIL-F-8785C §3.7.1.3 and the airworthiness codes shape it, along the mean wind:
///   v = g/2 (1 − cos 2πt/T) for t from 0 to T after its start.
struct GustParameters {
  double speed_m_s = 0.0;  ///< g
  double start_s = 20.0;
  double duration_s = 2.0;  ///< T
};

/// Mean wind, turbulence and one gust.
struct WeatherParameters {
  double mean_m_s = 0.0;
  double direction_rad = 0.0;        ///< where it blows to, from +x counter-clockwise
  double turbulence_m_s = 0.0;       ///< σ of the horizontal components
  double turbulence_height_m = 0.5;  ///< the height that the turbulence's scales are taken at
  GustParameters gust;

  /// Throws one std::invalid_argument that lists every fault.
  void validate() const;
};

double gust_speed_m_s(const GustParameters& gust, double t_s);

/// Mean wind with turbulence and a gust. The turbulence passes with the mean wind, at no less than 1 m/s: the
/// vehicle moves more slowly than that.
class Weather : public Wind {
 public:
  Weather(const WeatherParameters& parameters, std::uint64_t seed);
  Eigen::Vector3d velocity_W(Time t, const Eigen::Vector3d& p_WB) override;

 private:
  void bring_to(Time t);

  WeatherParameters parameters_;
  ConstantWind mean_;
  std::optional<Turbulence> turbulence_;
  Time turbulence_at_{0};
};

}  // namespace lineservo::vehicle
