// The figures of vehicle/autopilot/wind_rejection.md.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numbers>

#include "vehicle/attitude.h"
#include "vehicle/autopilot/attitude_controller.h"
#include "vehicle/autopilot/velocity_controller.h"
#include "vehicle/body/aerodynamics.h"
#include "vehicle/body/turbulence.h"
#include "vehicle/body/weather.h"
#include "vehicle/quadrotor.h"

namespace lineservo::vehicle {
namespace {

using Complex = std::complex<double>;
using Transfer = std::function<Complex(Complex s)>;

constexpr double kPeriod_s = seconds(kInertialPeriod);
constexpr double kSigma_m_s = 0.8, kMean_m_s = 1.5, kHeight_m = 0.5;

const Gains& gains() {
  static const Gains kGains{AirframeParameters{}};
  return kGains;
}

/// τ_r of the rate loop: rotors and one period.
double rate_lag_s() {
  return gains().rotor_lag_s + kPeriod_s;
}

// The tilt behind its command, as one lag and as the loops make it.
Complex one_lag(Complex s) {
  return 1.0 / (gains().attitude_lag_s * s + 1.0);
}
Complex tilt_chain(Complex s) {
  const double k = gains().rate_per_s, k_t = gains().attitude_per_s;
  return k * k_t / (rate_lag_s() * s * s * s + s * s + k * s + k * k_t);
}

Complex push_lag(Complex s) {
  return 1.0 / (gains().push_lag_s * s + 1.0);
}
/// F (1 + τ s F): what is tilted against over what pushes.
Complex led(Complex s) {
  return push_lag(s) * (1.0 + gains().attitude_lag_s * s * push_lag(s));
}

/// v/d with a tilt G: [1 − G F (1 + τ s F) + G k_a (1 − F)] / (s + k_d + G (k_v + k_a s)).
Complex answer(const Transfer& tilt, Complex s) {
  const Complex G = tilt(s);
  const double k_a = gains().acceleration_gain;
  return (1.0 - G * led(s) + G * k_a * (1.0 - push_lag(s))) /
         (s + gains().drag_per_s + G * (gains().velocity_per_s + k_a * s));
}

/// The same with PI on the velocity alone, k_p = 1/3τ and k_i = k_p²/5.
Complex answer_of_pi(Complex s) {
  const double k_p = 1.0 / (3.0 * gains().attitude_lag_s);
  return 1.0 / (s + gains().drag_per_s + tilt_chain(s) * (k_p + 0.2 * k_p * k_p / s));
}

double passing_s() {
  return TurbulenceScales::at_height(kHeight_m).along_m / kMean_m_s;
}
// Spectral densities of R = σ² e^(−τ/T) and of R = σ² e^(−τ/T) (1 − τ/2T).
double density_along(double w) {
  const double T = passing_s();
  return kSigma_m_s * kSigma_m_s * 2.0 * T / (1.0 + T * T * w * w);
}
double density_across(double w) {
  const double T = passing_s(), x = T * T * w * w;
  return kSigma_m_s * kSigma_m_s * T * (1.0 + 3.0 * x) / ((1.0 + x) * (1.0 + x));
}

/// σ² = 1/π ∫ |H|² S dω, over ln ω.
double sigma(const Transfer& H, const std::function<double(double)>& density) {
  constexpr double kStep = 0.01;
  double variance = 0.0;
  for (double x = std::log(1e-3); x < std::log(1e3); x += kStep) {
    const double w = std::exp(x);
    variance += std::norm(H({0.0, w})) * density(w) * w * kStep / std::numbers::pi;
  }
  return std::sqrt(variance);
}

/// Push over wind speed. The body's quadratic drag about the mean wind: twice as much along it as across.
double push_per_s(double body_share) {
  const AirframeParameters iris;
  return gains().drag_per_s +
         body_share * 0.5 * kAirDensity_kg_m3 * iris.body_drag_area_m2 * kMean_m_s / iris.mass_kg;
}

double sigma_along(const Transfer& H) {
  return push_per_s(2.0) * sigma(H, density_along);
}
double sigma_across(const Transfer& H) {
  return push_per_s(1.0) * sigma(H, density_across);
}

Complex as_it_is(Complex s) {
  return answer(tilt_chain, s);
}

TEST(WindRejection, TheTableOfThePage) {
  const Transfer push = [](Complex) { return 1.0; };
  EXPECT_NEAR(sigma_along(push), 0.316, 0.002);
  EXPECT_NEAR(sigma_across(push), 0.306, 0.002);
  EXPECT_NEAR(sigma_along(answer_of_pi), 0.063, 0.001);
  EXPECT_NEAR(sigma_across(answer_of_pi), 0.069, 0.001);
  EXPECT_NEAR(sigma_along(as_it_is), 0.0050, 0.0001);
  EXPECT_NEAR(sigma_across(as_it_is), 0.0058, 0.0001);
}

TEST(WindRejection, ThePolesAreRealAndTheFastOneIsTheTilts) {
  const double tau = gains().attitude_lag_s, b = 1.0 + gains().acceleration_gain;
  const double root = std::sqrt(b * b - 4.0 * tau * gains().velocity_per_s);
  EXPECT_NEAR((b - root) / (2.0 * tau), 1.3, 0.05);
  EXPECT_NEAR((b + root) / (2.0 * tau), 12.1, 0.05);
}

/// Frequencies upwards until the phase of L has passed −180° or its magnitude has passed 1.
template <typename Passed>
double first(Passed passed) {
  double w = 0.1;
  while (!passed(w)) w *= 1.001;
  return w;
}

TEST(WindRejection, TheMarginsOfThePage) {
  const auto loop = [](double w) {
    const Complex s(0.0, w);
    return tilt_chain(s) * (gains().acceleration_gain + gains().velocity_per_s / s);
  };
  const double crosses = first([&](double w) { return std::abs(loop(w)) < 1.0; });
  EXPECT_NEAR(180.0 + std::arg(loop(crosses)) * 180.0 / std::numbers::pi, 105.0, 2.0);
  const double turns = first([&](double w) { return loop(w).imag() > 0.0; });
  EXPECT_NEAR(1.0 / std::abs(loop(turns)), 8.9, 0.1);
}

TEST(WindRejection, TheThrustMayBeFarFromTheWeight) {
  double most = 0.0;
  for (double w = 0.1; w < 500.0; w *= 1.01) {
    const Complex s(0.0, w);
    most = std::max(most, std::abs(led(s) * tilt_chain(s)));
  }
  EXPECT_NEAR(1.0 / most, 0.67, 0.01);
}

/// One axis with a tilt of one lag, drag, and a push; the controller flies it at a period that is as good as
/// none.
class OneAxis {
 public:
  static constexpr double kFine_s = 5e-4;

  double velocity_m_s() const { return v_; }

  void period(double push_m_s2) {
    const Estimate e = estimate();
    const double command = controller_.acceleration_H({0.0, 0.0}, e, 0.0).x();
    tilt_m_s2_ += kFine_s / gains().attitude_lag_s * (command - tilt_m_s2_);
    a_m_s2_ = tilt_m_s2_ + push_m_s2 - gains().drag_per_s * v_;
    v_ += kFine_s * a_m_s2_;
  }

 private:
  Estimate estimate() const {
    Estimate e;
    e.pitch_rad = std::atan(tilt_m_s2_ / kGravity_m_s2);
    e.v_H_m_s.x() = v_;
    e.a_H_m_s2.x() = a_m_s2_;
    return e;
  }

  HorizontalController controller_{gains(), {}, kFine_s};
  double v_ = 0.0, tilt_m_s2_ = 0.0, a_m_s2_ = 0.0;
};

TEST(WindRejection, ASteadyPushLeavesNoVelocity) {
  OneAxis axis;
  for (int i = 0; i < 40000; ++i) axis.period(0.7);
  EXPECT_LT(std::abs(axis.velocity_m_s()), 1e-9);
}

TEST(WindRejection, TheControllerInTurbulenceIsTheFormula) {
  OneAxis axis;
  Turbulence wind(kSigma_m_s, kHeight_m, kMean_m_s, OneAxis::kFine_s, 8001);
  double v2 = 0.0;
  constexpr int kPeriods = 2'000'000;
  for (int i = 0; i < kPeriods; ++i, wind.step()) {
    axis.period(push_per_s(2.0) * wind.value().x());
    v2 += axis.velocity_m_s() * axis.velocity_m_s() / kPeriods;
  }
  const double formula = sigma_along([](Complex s) { return answer(one_lag, s); });
  EXPECT_NEAR(std::sqrt(v2), formula, 0.1 * formula);
}

// Sensors without errors; what is left is the wind.
TEST(WindRejection, SoIsTheVehicle) {
  WeatherParameters weather;
  weather.mean_m_s = kMean_m_s;
  weather.turbulence_m_s = kSigma_m_s;
  Quadrotor q({}, {}, SensorParameters::ideal(), std::make_unique<Weather>(weather, 8002), 1, {});
  Eigen::Vector2d v2 = Eigen::Vector2d::Zero();
  const Time begin = std::chrono::seconds(10), end = std::chrono::seconds(310);
  while (q.now() < end) {
    VelocitySetpoint hold;
    if (q.now() < std::chrono::milliseconds(1200)) hold.v_H_m_s.z() = 0.4;
    q.command(hold, q.now());
    q.paint_sighted(q.now());
    for (int i = 0; i < 20; ++i) {
      q.step();
      if (q.now() >= begin) v2 += 1e-3 / seconds(end - begin) * q.truth().v_W.head<2>().cwiseAbs2();
    }
  }
  EXPECT_NEAR(std::sqrt(v2.x()), sigma_along(as_it_is), 0.2 * sigma_along(as_it_is));
  EXPECT_NEAR(std::sqrt(v2.y()), sigma_across(as_it_is), 0.2 * sigma_across(as_it_is));
}

}  // namespace
}  // namespace lineservo::vehicle
