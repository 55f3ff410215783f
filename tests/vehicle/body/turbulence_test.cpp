#include "vehicle/body/turbulence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace lineservo::vehicle {
namespace {

constexpr double kStep_s = 0.05;

// One component over many of its correlation times.
std::vector<double> series(int component, double sigma, double height_m, double passing_m_s, int count) {
  Turbulence turbulence(sigma, height_m, passing_m_s, kStep_s, 11);
  std::vector<double> values;
  for (int i = 0; i < count; ++i, turbulence.step()) values.push_back(turbulence.value()[component]);
  return values;
}

double covariance(const std::vector<double>& values, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = lag; i < values.size(); ++i) sum += values[i] * values[i - lag];
  return sum / static_cast<double>(values.size() - lag);
}

// ∫ R(τ) cos(ωτ) over all τ, of the sampled covariance; it has died away after `lags`.
double density(const std::vector<double>& values, double frequency_rad_s, std::size_t lags) {
  double sum = covariance(values, 0);
  for (std::size_t k = 1; k < lags; ++k)
    sum += 2.0 * covariance(values, k) * std::cos(frequency_rad_s * kStep_s * static_cast<double>(k));
  return sum * kStep_s;
}

TEST(TurbulenceScales, AreThoseOfTheStandard) {
  const TurbulenceScales low = TurbulenceScales::at_height(100 * 0.3048);
  EXPECT_NEAR(low.along_m, 100 * 0.3048 / std::pow(0.177 + 0.0823, 1.2), 1e-9);
  EXPECT_NEAR(low.vertical_m, 100 * 0.3048, 1e-9);
  EXPECT_NEAR(low.vertical_share, std::pow(0.2593, 0.4), 1e-9);
  // At 1000 ft the standard's forms meet those of medium height: L_u = 1000 ft, σ_w = σ_u.
  const TurbulenceScales top = TurbulenceScales::at_height(1000 * 0.3048);
  EXPECT_NEAR(top.along_m, 304.8, 1e-6);
  EXPECT_NEAR(top.vertical_share, 1.0, 1e-9);
}

// A correlation time of 2.7 s in 100 000 s: the variance is known to 1/√18000 or so.
TEST(Turbulence, HasItsVarianceAndNoMean) {
  const double share = TurbulenceScales::at_height(0.5).vertical_share;
  for (const auto& [component, sigma] : {std::pair{0, 0.8}, {1, 0.8}, {2, 0.8 * share}}) {
    const std::vector<double> values = series(component, 0.8, 0.5, 1.5, 2'000'000);
    double mean = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    EXPECT_NEAR(mean, 0.0, 0.03 * sigma) << component;
    EXPECT_NEAR(std::sqrt(covariance(values, 0)), sigma, 0.03 * sigma) << component;
  }
}

TEST(Turbulence, HasTheAutocorrelationOfDryden) {
  const TurbulenceScales scales = TurbulenceScales::at_height(0.5);
  const auto along = [](double x) { return std::exp(-x); };
  const auto across = [](double x) { return std::exp(-x) * (1.0 - 0.5 * x); };
  const std::vector<std::pair<double, std::function<double(double)>>> forms = {
      {scales.along_m / 1.5, along}, {scales.along_m / 1.5, across}, {scales.vertical_m / 1.5, across}};
  for (int component = 0; component < 3; ++component) {
    const auto& [T_s, form] = forms[static_cast<std::size_t>(component)];
    const std::vector<double> values = series(component, 1.0, 0.5, 1.5, 2'000'000);
    const double variance = covariance(values, 0);
    for (const std::size_t lag : {1, 3, 10, 40, 120})
      EXPECT_NEAR(covariance(values, lag) / variance, form(static_cast<double>(lag) * kStep_s / T_s), 0.03)
          << component << " at " << lag;
  }
}

// Φ_u = σ² (2L/πV) / (1 + (TΩ)²), Φ_v = σ² (L/πV) (1 + 3 (Tω)²) / (1 + (Tω)²)², one-sided: π Φ is the
// integral over all τ.
TEST(Turbulence, HasTheSpectrumOfDryden) {
  const double T_s = TurbulenceScales::at_height(0.5).along_m / 1.5;
  const std::vector<double> along = series(0, 1.0, 0.5, 1.5, 1'000'000);
  const std::vector<double> across = series(1, 1.0, 0.5, 1.5, 1'000'000);
  for (const double w : {0.2, 0.5, 1.0, 2.0}) {
    const double x2 = T_s * T_s * w * w;
    EXPECT_NEAR(density(along, w, 300), 2.0 * T_s / (1.0 + x2), 0.06 * 2.0 * T_s) << w;
    EXPECT_NEAR(density(across, w, 300), T_s * (1.0 + 3.0 * x2) / ((1.0 + x2) * (1.0 + x2)), 0.06 * 2.0 * T_s)
        << w;
  }
}

TEST(Turbulence, TheStepDoesNotMatter) {
  // The process at every fifth step of one fifth has the same one-step correlation as at one step.
  Random fine_noise(1), coarse_noise(1);
  CrossTurbulence fine(1.0, 1.0, 0.02, fine_noise), coarse(1.0, 1.0, 0.1, coarse_noise);
  double fine_product = 0.0, coarse_product = 0.0;
  constexpr int kCount = 400000;
  for (int i = 0; i < kCount; ++i) {
    const double fine_before = fine.value(), coarse_before = coarse.value();
    for (int k = 0; k < 5; ++k) fine.step(fine_noise);
    coarse.step(coarse_noise);
    fine_product += fine_before * fine.value() / kCount;
    coarse_product += coarse_before * coarse.value() / kCount;
  }
  EXPECT_NEAR(fine_product, std::exp(-0.1) * 0.95, 0.02);
  EXPECT_NEAR(coarse_product, std::exp(-0.1) * 0.95, 0.02);
}

TEST(Turbulence, ShortStepsOfLongScalesStayFinite) {
  Turbulence turbulence(1.0, 300.0, 1.0, 1e-3, 1);
  for (int i = 0; i < 1000; ++i) turbulence.step();
  EXPECT_TRUE(turbulence.value().allFinite());
}

}  // namespace
}  // namespace lineservo::vehicle
