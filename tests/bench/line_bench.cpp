#include <benchmark/benchmark.h>

#include <opencv2/imgproc.hpp>

#include "features/line/line_methods.h"
#include "features/line/thinning.h"
#include "tests/features/line/drawn_stripe.h"

// What one 1920×1080 image costs, mask given, and Zhang–Suen thinning pixel by pixel beside ours.
namespace lineservo::features {
namespace {

const cv::Size kSize(1920, 1080);
const test::DrawnStripe kStripe = test::stripe_through(1000.0, 500.0, 12.0, 160.0);

cv::Mat picture() {
  cv::Mat image = test::draw_image(kSize, {kStripe});
  cv::Mat noise(kSize, CV_16SC3);
  cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
  cv::add(image, noise, image, cv::noArray(), CV_8UC3);
  return image;
}

void detect(benchmark::State& state, const LineMethod& method) {
  const cv::Mat image = picture();
  const auto detector = method.make();
  cv::Mat small;
  cv::resize(image, small, detector->mask_size(kSize), 0.0, 0.0, cv::INTER_AREA);
  const PackedMask mask = test::yellow_mask(small);
  for (auto _ : state) benchmark::DoNotOptimize(detector->detect({.image = image, .mask = mask}));
}

void thin(benchmark::State& state) {
  const PackedMask mask = test::draw_mask(kSize, {kStripe});
  Thinner thinner;
  for (auto _ : state) {
    PackedMask work = mask;
    thinner.thin(work);
    benchmark::DoNotOptimize(work.row(0).data());
  }
}
BENCHMARK(thin)->Unit(benchmark::kMillisecond);

// Byte by byte over the whole image, as the usual implementations go.
bool plain_pass(cv::Mat& image, cv::Mat& gone, int parity) {
  bool changed = false;
  gone.setTo(0);
  for (int y = 1; y + 1 < image.rows; ++y) {
    const std::uint8_t *a = image.ptr(y - 1), *h = image.ptr(y), *b = image.ptr(y + 1);
    for (int x = 1; x + 1 < image.cols; ++x) {
      if (!h[x]) continue;
      const int p[9] = {a[x], a[x + 1], h[x + 1], b[x + 1], b[x], b[x - 1], h[x - 1], a[x - 1], a[x]};
      int set = 0, rises = 0;
      for (int k = 0; k < 8; ++k) {
        set += p[k];
        rises += int{p[k] == 0 && p[k + 1] == 1};
      }
      const bool held = parity == 0 ? (p[2] && p[4] && (p[0] || p[6])) : (p[0] && p[6] && (p[2] || p[4]));
      if (set < 2 || set > 6 || rises != 1 || held) continue;
      gone.ptr(y)[x] = 1;
      changed = true;
    }
  }
  image -= gone;
  return changed;
}

void thin_plain(benchmark::State& state) {
  const cv::Mat mask = test::draw_mask(kSize, {kStripe}).to_mat() / 255;
  cv::Mat gone(kSize, CV_8UC1);
  for (auto _ : state) {
    cv::Mat work = mask.clone();
    for (bool changed = true; changed;) {
      const bool first = plain_pass(work, gone, 0);
      const bool second = plain_pass(work, gone, 1);
      changed = first || second;
    }
    benchmark::DoNotOptimize(work.data);
  }
}
BENCHMARK(thin_plain)->Unit(benchmark::kMillisecond);

const bool kRegistered = [] {
  for (const LineMethod& method : line_methods())
    benchmark::RegisterBenchmark(("detect/" + std::string(method.name)).c_str(),
                                 [&method](benchmark::State& state) { detect(state, method); })
        ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace lineservo::features
