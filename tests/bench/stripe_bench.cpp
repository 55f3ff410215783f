#include <benchmark/benchmark.h>

#include "features/stripe_perception.h"
#include "tests/features/test_masks.h"

// What one 400×400 mask costs, from packed words to lines, junction and code.
namespace lineservo::features {
namespace {

using test::kAhead;
using test::kBehind;
using test::kLeft;
using test::kRight;

enum class Wear { none, worn };

void observe(benchmark::State& state, const std::vector<double>& arms, double width_m, Wear wear) {
  const MaskGeometry geometry(CameraModel{CameraParameters{}}, test::kMaskSize, test::kMaskSize);
  const test::Pose pose{.x_m = -0.05, .y_m = 0.03, .heading_rad = 0.05, .roll_rad = 0.02, .pitch_rad = 0.02};
  test::TestMask mask = test::draw(geometry, pose, test::node_floor(arms, width_m));
  if (wear == Wear::worn) {
    test::TestRandom random(9);
    test::blot(mask, random, 0.25, 16.0, false);
    test::blot(mask, random, 0.02, 6.0, true);
  }
  StripePerception perception(geometry);
  const LevelView view = pose.view();
  for (auto _ : state) benchmark::DoNotOptimize(perception.observe(mask.view(), view).raw);
  state.counters["points"] = static_cast<double>(perception.border_points().size());
}

const std::vector<double> kStraight = {kAhead, kBehind};
const std::vector<double> kCross = {kAhead, kBehind, kLeft, kRight};
const std::vector<double> kCorner = {kBehind, kLeft};

BENCHMARK_CAPTURE(observe, straight_broad, kStraight, 0.36, Wear::none);
BENCHMARK_CAPTURE(observe, straight_tape, kStraight, 0.05, Wear::none);
BENCHMARK_CAPTURE(observe, cross_broad, kCross, 0.36, Wear::none);
BENCHMARK_CAPTURE(observe, cross_tape, kCross, 0.05, Wear::none);
BENCHMARK_CAPTURE(observe, corner_broad, kCorner, 0.36, Wear::none);
BENCHMARK_CAPTURE(observe, corner_tape, kCorner, 0.05, Wear::none);
BENCHMARK_CAPTURE(observe, cross_broad_worn, kCross, 0.36, Wear::worn);
BENCHMARK_CAPTURE(observe, cross_tape_worn, kCross, 0.05, Wear::worn);

}  // namespace
}  // namespace lineservo::features
