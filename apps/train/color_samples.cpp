#include "apps/train/color_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "vehicle/random.h"

namespace lineservo::apps {
namespace {

using features::LineColor;
using vehicle::Random;

/// How much of red, green and blue light a surface throws back.
struct Albedo {
  double r, g, b;
};

/// Between two surfaces, each channel by itself.
Albedo between(const Albedo& low, const Albedo& high, Random& random) {
  return {random.uniform(low.r, high.r), random.uniform(low.g, high.g), random.uniform(low.b, high.b)};
}

Albedo yellow(Random& random) {
  const double r = random.uniform(0.65, 0.95);
  return {r, r * random.uniform(0.68, 0.98), r * random.uniform(0.0, 0.35)};
}

Albedo red(Random& random) {
  const double r = random.uniform(0.5, 0.9);
  return {r, r * random.uniform(0.05, 0.35), r * random.uniform(0.05, 0.35)};
}

Albedo grey(double darkest, double lightest, Random& random) {
  const double level = random.uniform(darkest, lightest);
  return between({0.94 * level, 0.96 * level, 0.92 * level}, {1.04 * level, level, 1.04 * level}, random);
}

Albedo brown(Random& random) {
  const double r = random.uniform(0.3, 0.7);
  return {r, r * random.uniform(0.65, 0.88), r * random.uniform(0.45, 0.72)};
}

Albedo any_of_kind(LineColor color, Random& random) {
  switch (color) {
    case LineColor::yellow:
      return yellow(random);
    case LineColor::red:
      return red(random);
    case LineColor::white:
      return grey(0.75, 0.98, random);
    case LineColor::black:
      return grey(0.02, 0.1, random);
  }
  return {};
}

/// A floor, or a paint that is not the one that is looked for.
Albedo anything_else(LineColor paint, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.45) return grey(0.12, 0.7, random);
  if (kind < 0.65) return brown(random);
  if (kind < 0.85) {
    const auto other = static_cast<std::size_t>(random.uniform(0.0, 3.0));
    const auto at = std::find(features::kLineColors.begin(), features::kLineColors.end(), paint);
    const auto index = static_cast<std::size_t>(at - features::kLineColors.begin());
    return any_of_kind(features::kLineColors[(index + 1 + other) % features::kLineColors.size()], random);
  }
  return between({0.05, 0.2, 0.3}, {0.35, 0.6, 0.85}, random);  // greens and blues
}

/// light · (albedo · tint + glare) + noise, in levels.
cv::Vec3b seen(const Albedo& albedo, Random& random) {
  const double light = random.uniform(0.35, 1.15), warmth = random.uniform(-0.12, 0.12);
  const double glare = 0.25 * std::pow(random.uniform(), 4.0);
  const auto level = [&](double reflected, double tint) {
    const double value = 255.0 * light * (reflected * tint + glare) + random.normal(4.0);
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
  };
  return {level(albedo.b, 1.0 - warmth), level(albedo.g, 1.0), level(albedo.r, 1.0 + warmth)};
}

}  // namespace

std::vector<features::ColorSample> color_samples(LineColor paint, int count, std::uint64_t seed) {
  if (count < 2 || count > 100000) throw std::invalid_argument("colour samples: 2 to 100000");
  Random random(seed);
  std::vector<features::ColorSample> samples;
  for (int k = 0; k < count; ++k) {
    const bool is_paint = k % 2 == 0;
    const Albedo albedo = is_paint ? any_of_kind(paint, random) : anything_else(paint, random);
    samples.push_back({seen(albedo, random), is_paint});
  }
  return samples;
}

}  // namespace lineservo::apps
