// What each step of the segmentation costs, stock OpenCV calls beside ours, on one core and one 640×480
// frame.
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>

#include "features/junction/code_filter.h"
#include "features/junction/fpd.h"
#include "features/mask/path_segmenter.h"
#include "tests/support/floor_scenes.h"
#include "tests/support/stock_segmentation.h"

namespace lineservo {
namespace {

using features::Processor;
using support::stock_densities;
using support::StockSegmentation;

const cv::Size kVga(640, 480), kFullHd(1920, 1080);

// A wide cross and a red disc with the pixel noise of the `paper` conditions.
const cv::Mat& frame(cv::Size size = kVga) {
  static const cv::Mat vga = support::floor_scene(kVga, 7.0, 2.0),
                       full_hd = support::floor_scene(kFullHd, 7.0, 2.0);
  return size == kVga ? vga : full_hd;
}

StockSegmentation stock_after_all_steps() {
  cv::setNumThreads(1);
  StockSegmentation stock;
  stock.segment(frame());
  return stock;
}

void StockResize(benchmark::State& state) {
  StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) stock.resize(frame());
}
void StockColor(benchmark::State& state) {
  StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) stock.classify();
}
void StockMedian(benchmark::State& state) {
  StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) stock.median();
}
void StockClosing(benchmark::State& state) {
  StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) stock.close();
}
void StockDensities(benchmark::State& state) {
  const StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) benchmark::DoNotOptimize(stock_densities(stock.path));
}
void StockCentroid(benchmark::State& state) {
  const StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) benchmark::DoNotOptimize(cv::moments(stock.path, true).m10);
}
void StockAll(benchmark::State& state) {
  StockSegmentation stock = stock_after_all_steps();
  for (auto _ : state) {
    stock.segment(frame());
    benchmark::DoNotOptimize(stock_densities(stock.path));
    benchmark::DoNotOptimize(cv::moments(stock.path, true).m10);
  }
}

void ResizeAndColor(benchmark::State& state, Processor processor, cv::Size size) {
  const auto classifier = features::make_classifier({}, size, processor);
  features::PackedMask path(400, 400), marker(400, 400);
  for (auto _ : state) benchmark::DoNotOptimize(classifier->classify(frame(size), path, marker));
}

template <typename Step>
void filter_step(benchmark::State& state, Step step) {
  const auto in = features::PackedMask::from_mat(stock_after_all_steps().colored);
  features::PackedMask out = in;
  features::MaskFilter filter(400, 400);
  for (auto _ : state) {
    step(filter, in, out);
    benchmark::ClobberMemory();
  }
}
void Median(benchmark::State& state) {
  filter_step(state, [](auto& filter, const auto& in, auto& out) { filter.median_5x5(in, out); });
}
void Closing(benchmark::State& state) {
  filter_step(state, [](auto& filter, const auto& in, auto& out) { filter.close_5x5(in, out); });
}
void Profile(benchmark::State& state) {
  const auto mask = features::PackedMask::from_mat(stock_after_all_steps().path);
  features::MaskProfile profile;
  for (auto _ : state) {
    features::profile_of(mask, profile);
    benchmark::ClobberMemory();
  }
}
void DensitiesAndCode(benchmark::State& state) {
  const auto profile = features::profile_of(features::PackedMask::from_mat(stock_after_all_steps().path));
  for (auto _ : state)
    benchmark::DoNotOptimize(features::read_densities(features::pixel_densities(profile), 0).code);
}

void All(benchmark::State& state, Processor processor) {
  features::PathSegmenter segmenter({}, processor);
  features::MaskProfile profile;
  features::CodeFilter filter;
  for (auto _ : state) {
    const features::Segmentation& found = segmenter.segment(frame());
    features::profile_of(found.path, profile);
    benchmark::DoNotOptimize(features::centroid(profile));
    const auto reading = features::read_densities(features::pixel_densities(profile), found.marker_pixels);
    benchmark::DoNotOptimize(filter.update(reading.code, reading.line_ends_ahead));
  }
}

BENCHMARK(StockResize)->Unit(benchmark::kMicrosecond);
BENCHMARK(StockColor)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ResizeAndColor, best, features::best_processor(), kVga)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ResizeAndColor, avx2, Processor::avx2, kVga)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ResizeAndColor, portable, Processor::portable, kVga)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ResizeAndColor, full_hd, Processor::avx2, kFullHd)->Unit(benchmark::kMicrosecond);
BENCHMARK(StockMedian)->Unit(benchmark::kMicrosecond);
BENCHMARK(Median)->Unit(benchmark::kMicrosecond);
BENCHMARK(StockClosing)->Unit(benchmark::kMicrosecond);
BENCHMARK(Closing)->Unit(benchmark::kMicrosecond);
BENCHMARK(StockDensities)->Unit(benchmark::kMicrosecond);
BENCHMARK(StockCentroid)->Unit(benchmark::kMicrosecond);
BENCHMARK(Profile)->Unit(benchmark::kMicrosecond);
BENCHMARK(DensitiesAndCode)->Unit(benchmark::kMicrosecond);
BENCHMARK(StockAll)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(All, best, features::best_processor())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(All, avx2, Processor::avx2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(All, portable, Processor::portable)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace lineservo
