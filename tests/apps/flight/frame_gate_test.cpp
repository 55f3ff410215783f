#include "apps/flight/frame_gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace lineservo::apps {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Optional;
using vehicle::Frame;
using vehicle::Time;

constexpr Time kOldest = milliseconds(100), kPatience = milliseconds(250);
constexpr Time kPeriod = milliseconds(100), kLatency = milliseconds(50);

Frame frame(int k) {
  return {k * kPeriod, k, cv::Mat(40, 60, CV_8UC3, cv::Scalar::all(k % 251))};
}

class FrameGateTest : public testing::Test {
 protected:
  bool comes(const Frame& f, bool in_flight = true) {
    return gate_.accepts(f, f.stamp + kLatency, in_flight);
  }
  void come(int first, int last) {
    for (int k = first; k <= last; ++k) ASSERT_TRUE(comes(frame(k))) << k;
  }
  FrameGate gate_{kOldest, kPatience};
};

TEST_F(FrameGateTest, GoodFramesComeThroughWithoutAWord) {
  come(0, 30);
  EXPECT_FALSE(gate_.take_news().has_value());
}

TEST_F(FrameGateTest, AFrameComesThroughOnce) {
  come(0, 3);
  EXPECT_FALSE(comes(frame(3)));
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("out of order or twice")));
  EXPECT_FALSE(gate_.take_news().has_value());
  EXPECT_TRUE(comes(frame(4)));
}

TEST_F(FrameGateTest, AnOvertakenFrameDoesNotComeThrough) {
  come(0, 3);
  EXPECT_TRUE(comes(frame(5)));
  EXPECT_FALSE(gate_.accepts(frame(4), 5 * kPeriod + kLatency, true));
  EXPECT_TRUE(comes(frame(6)));
}

TEST_F(FrameGateTest, AFrameIsOfUseUpToItsAge) {
  EXPECT_TRUE(gate_.accepts(frame(1), kPeriod + kOldest, true));
  EXPECT_FALSE(gate_.accepts(frame(2), 2 * kPeriod + kOldest + Time(1), true));
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("late")));
}

// Or one wrong stamp would stand before all that follow.
TEST_F(FrameGateTest, AStampOfTheFutureShutsNoFrameOut) {
  come(0, 3);
  Frame wrong = frame(4);
  wrong.stamp += std::chrono::hours(1);
  EXPECT_FALSE(gate_.accepts(wrong, 4 * kPeriod + kLatency, true));
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("future")));
  come(5, 8);
}

TEST_F(FrameGateTest, AFrozenImageDoesNotComeThroughInFlight) {
  Frame frozen = frame(0);
  for (int k = 0; k < 5; ++k) {
    frozen.stamp = k * kPeriod;
    EXPECT_TRUE(comes(frozen, false)) << "on the ground nothing moves";
  }
  frozen.stamp = 5 * kPeriod;
  EXPECT_FALSE(comes(frozen));
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("does not change")));
  EXPECT_TRUE(comes(frame(6)));
}

TEST_F(FrameGateTest, AnImageOfAnotherSizeIsAnother) {
  EXPECT_TRUE(comes({Time(0), 0, cv::Mat::zeros(40, 60, CV_8UC3)}));
  EXPECT_TRUE(comes({kPeriod, 1, cv::Mat::zeros(40, 30, CV_8UC3)}));
}

TEST_F(FrameGateTest, GoesOnBlindAfterItsPatienceAndThenTenTimesASecond) {
  come(0, 3);
  const Time last = 3 * kPeriod + kLatency;
  int ticks = 0;
  Time first{0};
  for (Time now = last; now < last + std::chrono::seconds(1); now += milliseconds(1)) {
    if (!gate_.is_blind(now)) continue;
    if (ticks++ == 0) first = now;
  }
  EXPECT_EQ(first, last + kPatience);
  EXPECT_EQ(ticks, 8);
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("no frames come")));
}

TEST_F(FrameGateTest, FramesThatAreRefusedAreNoFrames) {
  come(0, 3);
  for (int k = 0; k < 5; ++k) gate_.accepts(frame(3), 4 * kPeriod + k * kPeriod, true);
  EXPECT_TRUE(gate_.is_blind(9 * kPeriod));
}

TEST_F(FrameGateTest, TellsOnceThatFramesAreGoodAgain) {
  come(0, 3);
  comes(frame(3));
  EXPECT_TRUE(gate_.take_news().has_value());
  come(4, 30);
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("good again")));
  come(31, 60);
  EXPECT_FALSE(gate_.take_news().has_value());
}

// One frame in three late is one fault, not one for each.
TEST_F(FrameGateTest, AFaultThatComesAndGoesIsToldOnce) {
  int told = 0;
  for (int k = 0; k < 60; ++k) {
    comes(frame(k));
    if (k % 3 == 0) comes(frame(k));
    told += gate_.take_news() ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
}

TEST_F(FrameGateTest, TellsOfEachFaultThatBeginsAfterAnotherIsOver) {
  come(0, 3);
  comes(frame(3));
  come(4, 30);
  gate_.take_news();
  EXPECT_TRUE(gate_.is_blind(34 * kPeriod));
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("no frames come")));
}

TEST_F(FrameGateTest, TellsOfACameraThatNeverSentAnything) {
  EXPECT_TRUE(gate_.is_blind(3 * kPeriod));
  EXPECT_THAT(gate_.take_news(), Optional(HasSubstr("no frames come")));
}

}  // namespace
}  // namespace lineservo::apps
