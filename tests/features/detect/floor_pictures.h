#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core/mat.hpp>

#include "features/mask/line_color.h"
#include "tests/features/test_masks.h"

/// Colour pictures of painted floors under uneven light, with exact ground truth. For tests alone.
namespace lineservo::features::test {

/// What a picture shows besides the paint.
struct Scene {
  cv::Vec3d floor_bgr{110.0, 112.0, 115.0};
  cv::Vec3d paint_bgr{40.0, 190.0, 225.0};
  double light_from = 1.0, light_to = 1.0;  ///< from the left border to the right one
  double joints_every_m = 0.0;              ///< dark joints, 4 mm wide, between tiles of this size; 0: none
  double planks_m = 0.0;                    ///< width of planks of wood across x; 0: none
  double plank_tone = 0.0;                  ///< share by which planks are lighter or darker
  double shadow = 1.0;                      ///< light left in the upper right corner, a soft edge
  double leg_shadow = 1.0;                  ///< light left in the shadows of two legs of a chair
  double glare = 0.0;                       ///< light added in a soft patch in the lower left, 255 = 1
  double noise = 2.0;                       ///< amplitude, in levels
  double texture = 0.0;                     ///< of the floor, in levels, in patches of about 3 cm
  std::uint64_t seed = 1;
};

inline cv::Vec3d paint_of(LineColor color) {
  switch (color) {
    case LineColor::yellow:
      return {40.0, 190.0, 225.0};
    case LineColor::red:
      return {45.0, 40.0, 200.0};
    case LineColor::white:
      return {225.0, 228.0, 230.0};
    case LineColor::black:
      return {32.0, 30.0, 30.0};
  }
  return {};
}

/// A floor that the paint shows on.
inline cv::Vec3d floor_for(LineColor color) {
  return color == LineColor::black ? cv::Vec3d(205.0, 208.0, 210.0) : cv::Vec3d(95.0, 97.0, 100.0);
}

inline double hashed(std::int64_t x, std::int64_t y, std::uint64_t seed) {
  TestRandom random(seed + static_cast<std::uint64_t>(x) * 73856093u +
                    static_cast<std::uint64_t>(y) * 19349663u);
  return random.uniform(-1.0, 1.0);
}

/// Value noise: a random height on every corner of a grid, bilinear in between.
inline double value_noise(double x, double y, std::uint64_t seed) {
  const auto ix = static_cast<std::int64_t>(std::floor(x)), iy = static_cast<std::int64_t>(std::floor(y));
  const double u = x - static_cast<double>(ix), v = y - static_cast<double>(iy);
  return (1 - v) * ((1 - u) * hashed(ix, iy, seed) + u * hashed(ix + 1, iy, seed)) +
         v * ((1 - u) * hashed(ix, iy + 1, seed) + u * hashed(ix + 1, iy + 1, seed));
}

inline bool on_joint(const Eigen::Vector2d& p, double every_m) {
  if (every_m <= 0.0) return false;
  const auto near = [every_m](double x) {
    return std::abs(std::remainder(x - 0.31 * every_m, every_m)) < 0.002;
  };
  return near(p.x()) || near(p.y());
}

/// Bands of 0.04 of the width that cross, with edges of 0.012.
inline double leg_shadow_at(double u, double v) {
  const auto band = [](double from_middle) {
    return std::clamp((0.02 - std::abs(from_middle)) / 0.012 + 0.5, 0.0, 1.0);
  };
  return std::max(band(u - 0.3 - 0.2 * v), band(0.9 * v + 0.3 * u - 0.6));
}

inline double light_at(const Scene& scene, double u, double v) {
  const double across = scene.light_from + (scene.light_to - scene.light_from) * u;
  const double into_shadow = std::clamp((u - v - 0.2) / 0.1, 0.0, 1.0);
  return across * (1.0 - (1.0 - scene.shadow) * into_shadow) *
         (1.0 - (1.0 - scene.leg_shadow) * leg_shadow_at(u, v));
}

/// Planks along y of tones of their own, each three of its widths and more long.
inline double plank_tone_at(const Scene& scene, const Eigen::Vector2d& p) {
  if (scene.planks_m <= 0.0) return 1.0;
  const double row = std::floor(p.x() / scene.planks_m);
  const auto of = static_cast<std::int64_t>(row);
  const double piece = std::floor(p.y() / (6.0 * scene.planks_m) + 0.5 * hashed(of, 7, scene.seed));
  return 1.0 + scene.plank_tone * hashed(of, static_cast<std::int64_t>(piece), scene.seed);
}

/// The picture that the camera of `geometry` takes at a pose.
inline cv::Mat photograph(const MaskGeometry& geometry, const Pose& pose, const Floor& floor,
                          const Scene& scene) {
  cv::Mat picture(geometry.height_px(), geometry.width_px(), CV_8UC3);
  TestRandom random(scene.seed);
  for_each_pixel(geometry, pose, [&](int x, int y, const Eigen::Vector2d& p) {
    const double u = static_cast<double>(x) / geometry.width_px(),
                 v = static_cast<double>(y) / geometry.height_px();
    cv::Vec3d color = floor.covers(p) ? scene.paint_bgr : scene.floor_bgr;
    if (!floor.covers(p)) {
      if (on_joint(p, scene.joints_every_m)) color *= 0.35;
      color *= plank_tone_at(scene, p);
      const double grain = scene.texture * value_noise(p.x() / 0.03, p.y() / 0.03, scene.seed);
      color += cv::Vec3d(grain, grain, grain);
    }
    const double glare =
        255.0 * scene.glare * std::exp(-30.0 * (std::pow(u - 0.25, 2) + std::pow(v - 0.75, 2)));
    for (int c = 0; c < 3; ++c) {
      const double level = color[c] * light_at(scene, u, v) + glare + scene.noise * random.uniform(-1.0, 1.0);
      picture.at<cv::Vec3b>(y, x)[c] = static_cast<std::uint8_t>(std::clamp(level, 0.0, 255.0));
    }
  });
  return picture;
}

/// Where a floor point lies in the picture.
inline PixelPoint pixel_of(const MaskGeometry& geometry, const Pose& pose, const Eigen::Vector2d& p_W) {
  const Eigen::Vector2d level = pose.level(p_W);
  const NormalizedPoint tilted = pose.view().tilted({level.x(), level.y()});
  return geometry.project(tilted);
}

}  // namespace lineservo::features::test
