#include "vehicle/floor/floor_light.h"

#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "vehicle/random.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;

enum Stream : std::uint64_t { kWave = 401, kShadow, kGlare };

bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

void require(bool holds, const char* fault) {
  if (!holds) throw std::invalid_argument(fault);
}

Vector2d drawn_direction(Random& random) {
  const double angle_rad = random.uniform(0.0, 2.0 * features::kPi);
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

double profile(const Vector2d& offset_W, double radius_m) {
  const double rest = 1.0 - offset_W.squaredNorm() / (radius_m * radius_m);
  return rest > 0.0 ? rest * rest : 0.0;
}

}  // namespace

void LightOptions::validate() const {
  require(within(low, 0.05, 2.0) && within(high, 0.05, 2.0), "light: low and high must be 0.05 to 2");
  require(within(wavelength_m, 0.5, 100.0), "light: the wavelength must be 0.5 to 100 m");
  require(within(glare, 0.0, 1.0), "light: the glare must be 0 to 1");
  require(within(glare_radius_m, 0.02, 1.0), "light: the glare's radius must be 0.02 to 1 m");
  require(within(glare_every_m, 1.0, 100.0), "light: the way between glares must be 1 to 100 m");
  require(within(shadow, 0.0, 0.9), "light: the shadow must be 0 to 0.9");
  require(within(shadow_radius_m, 0.02, 2.0), "light: the shadow's radius must be 0.02 to 2 m");
  require(within(shadow_offset, 0.0, 2.0), "light: the shadow's offset must be 0 to 2 heights");
}

FloorLight::FloorLight(const LightOptions& options, std::uint64_t seed) : options_(options), seed_(seed) {
  options.validate();
  Random wave(seed, kWave), shadow(seed, kShadow);
  wave_per_m_ = drawn_direction(wave) / options.wavelength_m;
  phase_ = wave.uniform();
  shadow_side_ = drawn_direction(shadow);
}

void FloorLight::look_near(const Eigen::Vector3d& p_W, double radius_m) {
  const Vector2d foot_W = p_W.head<2>();
  shadow_W_ = foot_W + options_.shadow_offset * p_W.z() * shadow_side_;
  glares_W_.clear();
  if (options_.glare == 0.0) return;
  const double reach_m = radius_m + options_.glare_radius_m, side_m = options_.glare_every_m;
  const auto square = [side_m](double c) { return static_cast<int>(std::floor(c / side_m)); };
  for (int x = square(foot_W.x() - reach_m); x <= square(foot_W.x() + reach_m); ++x)
    for (int y = square(foot_W.y() - reach_m); y <= square(foot_W.y() + reach_m); ++y) {
      const auto number = static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) |
                          static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32;
      Random random(Random(seed_, kGlare).bits(), number);
      const double along = random.uniform(), up = random.uniform();
      const Vector2d p(side_m * (x + along), side_m * (y + up));
      if ((p - foot_W).norm() < reach_m) glares_W_.push_back(p);
    }
}

Lighting FloorLight::at(const Vector2d& p_W) const {
  Lighting light;
  const double turns = wave_per_m_.dot(p_W) + phase_;
  const double t = std::abs(2.0 * (turns - std::floor(turns)) - 1.0);
  light.factor = options_.low + (options_.high - options_.low) * t * t * (3.0 - 2.0 * t);
  if (options_.shadow > 0.0)
    light.factor *= 1.0 - options_.shadow * profile(p_W - shadow_W_, options_.shadow_radius_m);
  for (const Vector2d& glare_W : glares_W_)
    light.glare += options_.glare * profile(p_W - glare_W, options_.glare_radius_m);
  return light;
}

}  // namespace lineservo::vehicle
