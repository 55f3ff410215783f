#include "apps/config/conditions_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/config/input_error.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

FlightRequest drawn(std::uint64_t seed) {
  FlightRequest request;
  request.seed = seed;
  apply_conditions(request, "paper..harsh");
  return request;
}

TEST(ConditionsRange, IsTwoNamesWithDotsBetween) {
  const auto range = conditions_range("paper..harsh");
  ASSERT_TRUE(range.has_value());
  EXPECT_EQ(range->from, "paper");
  EXPECT_EQ(range->to, "harsh");
  for (const char* other : {"paper", "../mine.yaml", "a/../b.yaml", "paper..", "..harsh", ""})
    EXPECT_FALSE(conditions_range(other).has_value()) << other;
  EXPECT_EQ(conditions_range("../a.yaml..b/../c.yaml")->from, "../a.yaml");
}

TEST(ConditionsRange, IsNoMoreThanTwo) {
  EXPECT_THAT(
      testing::complaint([] { conditions_range("ideal..paper..harsh"); }),
      ::testing::HasSubstr("--conditions ideal..paper..harsh: are more than two; allowed: one, or two"));
}

TEST(ConditionsRange, TheSameSeedDrawsTheSame) {
  EXPECT_EQ(config_text(drawn(5)), config_text(drawn(5)));
  EXPECT_NE(config_text(drawn(5)), config_text(drawn(6)));
}

TEST(ConditionsRange, EveryNumberLiesBetweenAndEveryGroupIsOnNowAndThen) {
  int windy = 0, fast = 0, still = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Settings s = drawn(seed).settings;
    EXPECT_GE(s.speed_m_s, 0.1);
    EXPECT_LE(s.speed_m_s, 0.5);
    EXPECT_GE(s.wind.mean_m_s, 0.0);
    EXPECT_LE(s.wind.mean_m_s, 1.5);
    EXPECT_GE(s.camera.frame_rate_hz, 10.0);
    EXPECT_LE(s.camera.frame_rate_hz, 30.0);
    windy += s.wind.mean_m_s > 0.0 ? 1 : 0;
    fast += s.speed_m_s > 0.1 ? 1 : 0;
    still += s.wind.mean_m_s == 0.0 && s.speed_m_s == 0.1 ? 1 : 0;
  }
  for (const int count : {windy, fast}) {
    EXPECT_GT(count, 15);
    EXPECT_LT(count, 45);
  }
  EXPECT_GT(still, 3);
}

TEST(ConditionsRange, WhatTheVehicleDoesAboutThemIsThatOfTheSecond) {
  FlightRequest harsh;
  apply_conditions(harsh, "harsh");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Settings s = drawn(seed).settings;
    EXPECT_EQ(s.features.segmenter, "any-light");
    EXPECT_EQ(s.executive.phases.hover_s, harsh.settings.executive.phases.hover_s);
  }
}

TEST(ConditionsRange, AnUnknownEndIsAnError) {
  FlightRequest request;
  EXPECT_THROW(apply_conditions(request, "paper..nowhere"), InputError);
}

}  // namespace
}  // namespace lineservo::apps
