#include "vehicle/floor/frame_link.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace lineservo::vehicle {
namespace {

constexpr Time kPeriod = std::chrono::milliseconds(33);

std::vector<double> latencies_s(const FrameLinkOptions& options, std::uint64_t seed, int count) {
  FrameLink link(options, seed);
  std::vector<double> all;
  for (int k = 0; k < count; ++k)
    all.push_back(seconds(link.arrival(k, k * kPeriod, k * kPeriod) - k * kPeriod));
  return all;
}

TEST(FrameLink, WithoutJitterTheLatencyIsWhatItSays) {
  for (const double latency_s : latencies_s({0.06, 0.0, 0.0}, 1, 100)) EXPECT_NEAR(latency_s, 0.06, 1e-9);
}

// Uniform on ±j: mean the latency, variance j²/3.
TEST(FrameLink, JitterIsUniformAboutTheLatency) {
  constexpr int kCount = 20000;
  const std::vector<double> all = latencies_s({0.06, 0.01, 0.0}, 1, kCount);
  double mean = 0.0, variance = 0.0;
  for (const double latency_s : all) {
    ASSERT_LE(std::abs(latency_s - 0.06), 0.01 + 1e-9);
    mean += latency_s / kCount;
    variance += (latency_s - 0.06) * (latency_s - 0.06) / kCount;
  }
  EXPECT_NEAR(mean, 0.06, 2e-4);
  EXPECT_NEAR(std::sqrt(variance), 0.01 / std::sqrt(3.0), 1e-4);
}

TEST(FrameLink, FramesNeverOvertakeEachOther) {
  FrameLink link({0.1, 0.09, 0.0}, 3);
  Time last{-1};
  for (int k = 0; k < 2000; ++k) {
    const Time arrival = link.arrival(k, k * kPeriod, k * kPeriod);
    ASSERT_GT(arrival, last);
    ASSERT_GE(arrival, k * kPeriod + std::chrono::milliseconds(10));
    last = arrival;
  }
}

TEST(FrameLink, NoFrameArrivesBeforeItIsReadOut) {
  FrameLink link({0.002, 0.0, 0.0}, 3);
  EXPECT_EQ(link.arrival(0, Time(0), std::chrono::milliseconds(11)), Time(std::chrono::milliseconds(11)));
}

// Each frame by itself: the share within 3 σ of a binomial, and after a lost one it is the same.
TEST(FrameLink, LosesItsShareOfTheFramesIndependently) {
  const FrameLink link({0.0, 0.0, 0.05}, 5);
  constexpr int kCount = 40000;
  int lost = 0, both = 0;
  for (int k = 0; k < kCount; ++k) {
    lost += link.loses(k) ? 1 : 0;
    both += link.loses(k) && link.loses(k + 1) ? 1 : 0;
  }
  EXPECT_NEAR(lost, 0.05 * kCount, 3.0 * std::sqrt(0.05 * 0.95 * kCount));
  EXPECT_NEAR(both, 0.0025 * kCount, 3.0 * std::sqrt(0.0025 * kCount));
}

TEST(FrameLink, TheSeedAndTheIndexDecide) {
  EXPECT_EQ(latencies_s({0.06, 0.01, 0.0}, 1, 20), latencies_s({0.06, 0.01, 0.3}, 1, 20));
  EXPECT_NE(latencies_s({0.06, 0.01, 0.0}, 1, 20), latencies_s({0.06, 0.01, 0.0}, 2, 20));
}

TEST(FrameLink, RefusesWhatIsOutOfBounds) {
  EXPECT_THROW(FrameLink({-0.1, 0.0, 0.0}, 1), std::invalid_argument);
  EXPECT_THROW(FrameLink({0.0, 0.6, 0.0}, 1), std::invalid_argument);
  EXPECT_THROW(FrameLink({0.0, 0.0, std::nan("")}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
