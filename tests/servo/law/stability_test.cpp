// The figures of servo/law/stability.md.
#include <gtest/gtest.h>

#include <deque>

#include "servo/law/ibvs_line_law.h"
#include "tests/servo/law/closed_loop.h"

namespace lineservo::servo {
namespace {

using testing::ClosedLoop;
using testing::LoopParameters;

constexpr int kAt30Hz = 10, kAt10Hz = 30, kDelay50Ms = 15;

double largest_pole(const LoopParameters& parameters) {
  return ClosedLoop(parameters).spectral_radius();
}

/// The largest delay that the law does not know of and that leaves the loop stable, in milliseconds.
double delay_margin_ms(LoopParameters parameters) {
  int stable = 0, unstable = 300;
  while (unstable - stable > 1) {
    parameters.unknown_delay_steps = (stable + unstable) / 2;
    (largest_pole(parameters) < 1.0 ? stable : unstable) = parameters.unknown_delay_steps;
  }
  return 1000.0 * ClosedLoop::kStep_s * stable;
}

/// The settling time constant that a pole of a frame period stands for.
double time_constant_s(double pole, int frame_steps) {
  return -frame_steps * ClosedLoop::kStep_s / std::log(pole);
}

/// One row of the table.
struct Row {
  double gain_per_s;
  double time_constant_s, margin_ms;            ///< at 30 frames/s
  double time_constant_10hz_s, margin_10hz_ms;  ///< at 10 frames/s
};

TEST(Stability, TheTableOfThePage) {
  for (const Row& row : {Row{1.0, 0.72, 387, 0.67, 380}, Row{2.0, 0.34, 247, 0.41, 230},
                         Row{3.0, 0.45, 180, 0.56, 160}, Row{4.0, 0.56, 137, 0.75, 117}}) {
    LoopParameters fast{.frame_steps = kAt30Hz, .delay_steps = kDelay50Ms, .gain_per_s = row.gain_per_s};
    LoopParameters slow{.frame_steps = kAt10Hz, .delay_steps = kDelay50Ms, .gain_per_s = row.gain_per_s};
    EXPECT_NEAR(time_constant_s(largest_pole(fast), kAt30Hz), row.time_constant_s, 0.006) << row.gain_per_s;
    EXPECT_NEAR(time_constant_s(largest_pole(slow), kAt10Hz), row.time_constant_10hz_s, 0.006)
        << row.gain_per_s;
    EXPECT_NEAR(delay_margin_ms(fast), row.margin_ms, 2.0) << row.gain_per_s;
    EXPECT_NEAR(delay_margin_ms(slow), row.margin_10hz_ms, 2.0) << row.gain_per_s;
  }
}

// With the delay known to the step it is compensated: the poles are those without any delay, and some at
// zero.
TEST(Stability, AKnownDelayMovesNoPole) {
  for (const int frame_steps : {kAt30Hz, kAt10Hz}) {
    const double without = largest_pole({.frame_steps = frame_steps, .delay_steps = 0});
    for (const int delay_steps : {3, 15, 60})
      EXPECT_NEAR(largest_pole({.frame_steps = frame_steps, .delay_steps = delay_steps}), without, 1e-3);
  }
}

/// The vehicle of the model with the law itself in the loop: offset and velocity across the line.
class LawInTheLoop {
 public:
  LawInTheLoop(const LoopParameters& p, double offset_m)
      : p_(p),
        law_(options(p)),
        offsets_(static_cast<std::size_t>(p.delay_steps + p.unknown_delay_steps + 1), offset_m) {}

  double offset_m() const { return offsets_.front(); }

  void frame_period() {
    Observation o;
    o.now = at(step_);
    o.captured = at(step_ - p_.delay_steps);
    o.features.lines.resize(1);
    o.features.lines[0].rho = offsets_.back() / kHeight_m;
    o.estimate.height_m = o.estimate.capture_height_m = kHeight_m;
    o.estimate.odometry_now.translation_m.y() = offsets_.front();
    o.estimate.odometry_at_capture.translation_m.y() = offsets_[static_cast<std::size_t>(p_.delay_steps)];
    const double command = std::get<VelocityCommand>(law_.follow(o, {0.1, kHeight_m})).left_m_s;
    for (int k = 0; k < p_.frame_steps; ++k) vehicle_step(command);
  }

 private:
  static constexpr double kHeight_m = 0.5;
  static Time at(int step) {
    return Time{static_cast<std::int64_t>(step * ClosedLoop::kStep_s * 1e9) + 1'000'000'000};
  }
  static IbvsLineOptions options(const LoopParameters& p) {
    IbvsLineOptions options;
    options.gain = {p.gain_per_s, p.gain_per_s, 0.0};
    options.drift_time_constant_s = p.drift_time_constant_s;
    return options;
  }
  void vehicle_step(double command) {
    const double w = p_.answer_rad_s, dt = ClosedLoop::kStep_s;
    acceleration_ += dt * (w * w * (command - velocity_) - 2.0 * p_.answer_damping * w * acceleration_);
    velocity_ += dt * acceleration_;
    offsets_.push_front(offsets_.front() + dt * velocity_);
    offsets_.pop_back();
    ++step_;
  }

  LoopParameters p_;
  IbvsLineLaw law_;
  std::deque<double> offsets_;
  double velocity_ = 0.0, acceleration_ = 0.0;
  int step_ = 0;
};

TEST(Stability, TheModelIsTheLaw) {
  for (const int frame_steps : {kAt30Hz, kAt10Hz}) {
    for (const int unknown : {0, 3, 9}) {
      const LoopParameters p{
          .frame_steps = frame_steps, .delay_steps = kDelay50Ms, .unknown_delay_steps = unknown};
      ClosedLoop model(p);
      model.rest_at(0.05);
      LawInTheLoop law(p, 0.05);
      for (int k = 0; k < 60; ++k) {
        model.frame_period();
        law.frame_period();
        ASSERT_NEAR(law.offset_m(), model.offset_m(), 1e-6) << frame_steps << ' ' << unknown << ' ' << k;
      }
    }
  }
}

}  // namespace
}  // namespace lineservo::servo
