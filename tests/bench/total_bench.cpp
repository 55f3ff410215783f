// What the whole of perception costs, from a 640×480 BGR frame to mask, densities, lines, junction and code,
// beside the mask and the densities alone in stock OpenCV calls: on one core, on the frames of a flight.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <opencv2/core/utility.hpp>

#include "features/perception.h"
#include "tests/support/flight_frames.h"
#include "tests/support/stock_segmentation.h"

namespace lineservo {
namespace {

using Clock = std::chrono::steady_clock;
using support::FlightFrame;
using support::FlightScene;
using support::StockSegmentation;

constexpr int kFrames = 24;

features::Perception perception(features::JunctionMethod method) {
  features::PerceptionOptions options;
  options.junction_method = method;
  return {features::CameraModel(features::CameraParameters{}), options};
}

void observe(features::Perception& ours, const cv::Mat& bgr, const features::LevelView& view) {
  benchmark::DoNotOptimize(ours.observe(bgr, {view, 0.5, 0.1}).code.raw);
}

// Resize, HSV, ranges, median, closing; the 80 densities; the centroid. No line, no junction.
void stock_steps(StockSegmentation& stock, const cv::Mat& bgr) {
  stock.segment(bgr);
  benchmark::DoNotOptimize(support::stock_densities(stock.path));
  benchmark::DoNotOptimize(cv::moments(stock.path, true).m10);
}

bool masks_agree(features::Perception& ours, StockSegmentation& stock,
                 const std::vector<FlightFrame>& frames) {
  return std::all_of(frames.begin(), frames.end(), [&](const FlightFrame& frame) {
    ours.observe(frame.bgr, {frame.view, 0.5, 0.1});
    stock.segment(frame.bgr);
    return ours.mask() == features::PackedMask::from_mat(stock.path);
  });
}

// Seconds a frame of `work`, each frame freshly written to the buffer that a grabber would hand over.
template <typename Work>
double seconds_a_frame(const std::vector<FlightFrame>& frames, cv::Mat& buffer, Work work) {
  Clock::duration spent{0};
  for (const FlightFrame& frame : frames) {
    frame.bgr.copyTo(buffer);
    const Clock::time_point begin = Clock::now();
    work(frame);
    spent += Clock::now() - begin;
  }
  return std::chrono::duration<double>(spent).count() / static_cast<double>(frames.size());
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Ours and stock take turns over the same frames; each figure is the median over the turns, per frame.
void total(benchmark::State& state, const FlightScene& scene, features::JunctionMethod method) {
  cv::setNumThreads(1);
  const std::vector<FlightFrame> frames = support::frames_along_a13(scene, kFrames);
  features::Perception ours = perception(method);
  StockSegmentation stock;
  if (!masks_agree(ours, stock, frames)) state.SkipWithError("the masks differ");
  cv::Mat buffer;
  std::vector<double> ours_us, stock_us;
  for (auto _ : state) {
    const double ours_s =
        seconds_a_frame(frames, buffer, [&](const FlightFrame& frame) { observe(ours, buffer, frame.view); });
    const double stock_s =
        seconds_a_frame(frames, buffer, [&](const FlightFrame&) { stock_steps(stock, buffer); });
    state.SetIterationTime(ours_s);
    ours_us.push_back(1e6 * ours_s);
    stock_us.push_back(1e6 * stock_s);
  }
  if (ours_us.empty()) return;
  state.counters["perception_us"] = median(ours_us);
  state.counters["stock_us"] = median(stock_us);
  state.counters["times_faster"] = median(stock_us) / median(ours_us);
}

const bool kRegistered = [] {
  for (const FlightScene& scene : support::flight_scenes())
    benchmark::RegisterBenchmark(("perception_total/" + scene.name).c_str(), total, scene,
                                 features::JunctionMethod::stripe)
        ->UseManualTime()
        ->Iterations(60)
        ->Unit(benchmark::kMicrosecond);
  return true;
}();

}  // namespace
}  // namespace lineservo
