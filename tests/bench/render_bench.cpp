// What a synthetic frame costs: 640×480, f = 320 px, 0.5 m above the warehouse and the other shipped shapes.
#include <benchmark/benchmark.h>

#include <opencv2/core.hpp>

#include "tests/vehicle/floor/floor_from_above.h"
#include "tests/vehicle/floor/render_oracle.h"
#include "tests/vehicle/floor/test_layouts.h"
#include "vehicle/floor/floor_renderer.h"
#include "vehicle/floor/image_noise.h"

namespace lineservo::vehicle {
namespace {

using test::camera_pose;

struct Scene {
  Layout layout;
  Eigen::Isometry3d X_WC;
};

Scene along_an_aisle() {
  return {test::warehouse(), camera_pose({6.0, 0.62, 0.5}, 0.03, 0.02, -0.02)};
}
Scene over_a_cross() {
  return {test::warehouse(), camera_pose({4.22, 0.58 + 6.8 / 3.0, 0.5}, 0.03, 0.02, -0.02)};
}
Scene over_the_start() {
  return {test::warehouse(), camera_pose({0.62, 0.58, 0.5}, 0.03, 0.02, -0.02)};
}
Scene on_a_circle() {
  return {test::circle(), camera_pose({5.28, 0.1, 0.5}, 1.55, 0.02, -0.02)};
}

/// A picture of the cross in the place of its paint.
Scene over_a_pictured_cross() {
  Scene scene = over_a_cross();
  scene.layout.bitmap = test::floor_from_above(scene.layout, {3.2, 1.9}, 1000, 1000, 0.002).bitmap();
  return scene;
}

template <Scene (*scene)()>
void draw(benchmark::State& state, const features::CameraModel& camera, double noise_sigma) {
  const Scene seen = scene();
  FloorRenderer renderer(seen.layout, camera);
  const ImageNoise noise(noise_sigma, 1);
  cv::Mat bgr;
  std::int64_t frame = 0;
  for (auto _ : state) {
    renderer.render(seen.X_WC, bgr);
    noise.add(frame++, bgr);
    benchmark::DoNotOptimize(bgr.data);
    benchmark::ClobberMemory();
  }
}

template <Scene (*scene)()>
void plain(benchmark::State& state) {
  draw<scene>(state, test::pinhole(), 0.0);
}
template <Scene (*scene)()>
void noisy(benchmark::State& state) {
  draw<scene>(state, test::pinhole(), 2.0 / 255.0);
}
template <Scene (*scene)()>
void distorted(benchmark::State& state) {
  draw<scene>(state, test::distorting(), 0.0);
}

FloorLook harsh_look() {
  FloorLook look;
  look.wear.worn_share = 0.25;
  look.wear.gap_m = 0.1;
  look.wear.dirt_share = 0.02;
  look.light.low = 0.4;
  look.light.high = 1.3;
  look.light.glare = 0.8;
  return look;
}

// Flown over at 0.5 m/s, nodding at 10 degrees a second.
template <Scene (*scene)()>
void exposed(benchmark::State& state, const FloorLook& look, const ShutterOptions& shutter,
             double noise_sigma) {
  const Scene seen = scene();
  FloorRenderer renderer(seen.layout, test::pinhole(), look, 1);
  ShutterWarp warp(renderer.grid(), shutter);
  const ImageNoise noise(noise_sigma, 1);
  const auto motion = [&](double t_s) {
    Eigen::Isometry3d X_WC = seen.X_WC;
    X_WC.translation() += 0.5 * t_s * Eigen::Vector3d::UnitX();
    X_WC.rotate(Eigen::AngleAxisd(0.17 * t_s, Eigen::Vector3d::UnitX()));
    return X_WC;
  };
  cv::Mat bgr;
  std::int64_t frame = 0;
  for (auto _ : state) {
    shutter.is_instant() ? renderer.render(seen.X_WC, bgr) : renderer.render(motion, warp, bgr);
    noise.add(frame++, bgr);
    benchmark::DoNotOptimize(bgr.data);
    benchmark::ClobberMemory();
  }
}
ShutterOptions harsh_shutter() {
  return {.exposure_s = 0.008, .readout_s = 0.015, .samples = 5};
}
template <Scene (*scene)()>
void blurred(benchmark::State& state) {
  exposed<scene>(state, {}, harsh_shutter(), 0.0);
}
template <Scene (*scene)()>
void worn(benchmark::State& state) {
  exposed<scene>(state, {harsh_look().wear, {}}, {}, 0.0);
}
template <Scene (*scene)()>
void lit(benchmark::State& state) {
  exposed<scene>(state, {{}, harsh_look().light}, {}, 0.0);
}
template <Scene (*scene)()>
void harsh(benchmark::State& state) {
  exposed<scene>(state, harsh_look(), harsh_shutter(), 6.0 / 255.0);
}

BENCHMARK(plain<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(plain<over_a_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(plain<over_the_start>)->Unit(benchmark::kMicrosecond);
BENCHMARK(plain<on_a_circle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(plain<over_a_pictured_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(noisy<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(noisy<over_a_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(distorted<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(distorted<over_a_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(distorted<on_a_circle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(blurred<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(blurred<over_a_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(blurred<over_a_pictured_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(worn<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(worn<over_a_cross>)->Unit(benchmark::kMicrosecond);
BENCHMARK(lit<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(harsh<along_an_aisle>)->Unit(benchmark::kMicrosecond);
BENCHMARK(harsh<over_a_cross>)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace lineservo::vehicle
