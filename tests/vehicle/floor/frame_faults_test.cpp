#include "vehicle/floor/frame_faults.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

namespace lineservo::vehicle {
namespace {

using std::chrono::milliseconds;

constexpr Time kPeriod = milliseconds(100);
constexpr FaultWindow kSecondSecond{1.0, 1.0};  // frames 10 to 19 of ten a second

FrameFaultOptions only(FaultWindow FrameFaultOptions::*fault, const FaultWindow& window) {
  FrameFaultOptions options;
  options.*fault = window;
  return options;
}

/// Every frame has a brightness of its own.
Frame frame(int k) {
  return {k * kPeriod, k, cv::Mat(4, 6, CV_8UC3, cv::Scalar::all(k + 1.0))};
}

struct Delivery {
  std::int64_t index;
  Time stamp, at;
  int brightness;
};

/// Thirty frames through the faults, asked every millisecond.
std::vector<Delivery> deliveries(const FrameFaultOptions& options) {
  FrameFaults faults(options);
  std::vector<Delivery> all;
  for (Time now{0}; now < 33 * kPeriod; now += milliseconds(1)) {
    if (now % kPeriod == Time(0) && now < 30 * kPeriod)
      faults.take(frame(static_cast<int>(now / kPeriod)), now);
    while (const auto out = faults.deliver(now))
      all.push_back({out->index, out->stamp, now, out->bgr.at<cv::Vec3b>(3, 5)[1]});
  }
  return all;
}

bool is_spoilt(std::int64_t index) {
  return index >= 10 && index < 20;
}

TEST(FrameFaults, WithoutAnyEachFrameComesAtOnceAsItIs) {
  const auto all = deliveries({});
  ASSERT_EQ(all.size(), 30u);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].index, static_cast<std::int64_t>(k));
    EXPECT_EQ(all[k].at, all[k].stamp);
    EXPECT_EQ(all[k].brightness, static_cast<int>(k) + 1);
  }
}

TEST(FrameFaults, NothingComesWhereNothingWasTaken) {
  FrameFaults faults({});
  EXPECT_FALSE(faults.deliver(kPeriod).has_value());
}

TEST(FrameFaults, BlackFramesKeepTheirStampsAndTheirSize) {
  const auto all = deliveries(only(&FrameFaultOptions::black, kSecondSecond));
  ASSERT_EQ(all.size(), 30u);
  for (const Delivery& d : all) {
    EXPECT_EQ(d.at, d.stamp);
    EXPECT_EQ(d.brightness, is_spoilt(d.index) ? 0 : d.index + 1);
  }
}

TEST(FrameFaults, AFrozenCameraShowsTheLastFrameBefore) {
  const auto all = deliveries(only(&FrameFaultOptions::frozen, kSecondSecond));
  ASSERT_EQ(all.size(), 30u);
  for (const Delivery& d : all) EXPECT_EQ(d.brightness, is_spoilt(d.index) ? 10 : d.index + 1);
  EXPECT_EQ(all[15].stamp, 15 * kPeriod);
}

// The spoilt image must not be the camera's own, which others may hold.
TEST(FrameFaults, LeavesTheImageItWasGivenAlone) {
  FrameFaults faults(only(&FrameFaultOptions::black, {0.0, 1.0}));
  const Frame given = frame(3);
  faults.take(given, given.stamp);
  EXPECT_EQ(given.bgr.at<cv::Vec3b>(0, 0)[0], 4);
  EXPECT_EQ(faults.deliver(given.stamp)->bgr.at<cv::Vec3b>(0, 0)[0], 0);
}

TEST(FrameFaults, ASilentCameraSendsNothingAndComesBack) {
  const auto all = deliveries(only(&FrameFaultOptions::silent, kSecondSecond));
  ASSERT_EQ(all.size(), 20u);
  for (const Delivery& d : all) EXPECT_FALSE(is_spoilt(d.index)) << d.index;
}

TEST(FrameFaults, OneFrameInThreeComesBehindThoseThatFollow) {
  const auto all = deliveries(only(&FrameFaultOptions::late, kSecondSecond));
  ASSERT_EQ(all.size(), 30u);
  int late = 0, overtaken = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_late = all[k].at > all[k].stamp;
    late += is_late ? 1 : 0;
    EXPECT_EQ(all[k].at - all[k].stamp, is_late ? FrameFaults::kLate : Time(0));
    EXPECT_TRUE(!is_late || is_spoilt(all[k].index));
    if (k == 0) continue;
    EXPECT_GE(all[k].at, all[k - 1].at);
    overtaken += all[k].stamp < all[k - 1].stamp ? 1 : 0;
  }
  EXPECT_EQ(late, 3);  // 12, 15, 18
  EXPECT_EQ(overtaken, 3);
}

TEST(FrameFaults, EveryFrameComesAgainALittleLater) {
  const auto all = deliveries(only(&FrameFaultOptions::twice, kSecondSecond));
  ASSERT_EQ(all.size(), 40u);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const bool again = all[k].index == all[k - 1].index;
    EXPECT_EQ(all[k].at - all[k].stamp, again ? FrameFaults::kAgain : Time(0)) << all[k].index;
    EXPECT_EQ(all[k].brightness, all[k].index + 1);
  }
}

TEST(FrameFaults, AWindowThatLastsNoTimeNeverOpens) {
  EXPECT_EQ(deliveries(only(&FrameFaultOptions::silent, {1.0, 0.0})).size(), 30u);
}

}  // namespace
}  // namespace lineservo::vehicle
