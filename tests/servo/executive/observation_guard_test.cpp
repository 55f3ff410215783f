#include "servo/executive/observation_guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace lineservo::servo {
namespace {

using testing::HasSubstr;
using testing::Optional;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Observation sound(int k) {
  Observation o;
  o.now = k * std::chrono::milliseconds(100);
  o.captured = o.now - std::chrono::milliseconds(50);
  o.estimate.odometry_now = {{0.1 * k, 0.2}, 0.3};
  o.estimate.odometry_at_capture = {{0.1 * k - 0.05, 0.2}, 0.29};
  o.estimate.height_m = o.estimate.capture_height_m = 0.5 + 0.01 * k;
  o.estimate.v_H_m_s << 0.1, 0.0, 0.01 * k;
  o.features.lines.resize(2);
  o.features.lines[1].rho = 0.4;
  o.features.junction.emplace();
  o.features.junction->arms.resize(3);
  o.features.line_end = features::LevelPoint{0.1, 0.2};
  o.features.centroid_px = features::PixelPoint{200.0, 190.0};
  o.features.start_marker = features::LevelPoint{0.0, 0.1};
  o.features.law = {.centroid = features::LevelPoint{0.1, 0.0},
                    .lines = {features::LineFeature{}},
                    .ahead = features::LevelPoint{0.0, -0.7},
                    .behind = features::LevelPoint{0.0, 0.7},
                    .target = features::LevelPoint{0.0, -0.3}};
  return o;
}

TEST(ObservationGuard, WhatIsSoundComesThroughAsItIs) {
  ObservationGuard guard;
  for (int k = 0; k < 5; ++k) {
    const Observation o = sound(k);
    EXPECT_EQ(&guard.checked(o), &o);
    EXPECT_EQ(guard.bad_for_s(), 0.0);
    EXPECT_FALSE(guard.take_news().has_value());
  }
}

using Spoil = std::function<void(features::FrameFeatures&, double)>;
using Seen = std::function<bool(const features::FrameFeatures&)>;

// Each number of perception in turn: the feature that it belongs to is not seen, and all others are.
TEST(ObservationGuard, AFeatureThatIsNotFiniteWasNotSeen) {
  const std::vector<std::pair<Spoil, Seen>> all{
      {[](auto& f, double v) { f.junction->centre.y = v; },
       [](const auto& f) { return f.junction.has_value(); }},
      {[](auto& f, double v) { f.junction->arms[2].angle_rad = v; },
       [](const auto& f) { return f.junction.has_value(); }},
      {[](auto& f, double v) { f.line_end->x = v; }, [](const auto& f) { return f.line_end.has_value(); }},
      {[](auto& f, double v) { f.centroid_px->x = v; },
       [](const auto& f) { return f.centroid_px.has_value(); }},
      {[](auto& f, double v) { f.start_marker->y = v; },
       [](const auto& f) { return f.start_marker.has_value(); }},
      {[](auto& f, double v) { f.law.centroid->x = v; },
       [](const auto& f) { return f.law.centroid.has_value(); }},
      {[](auto& f, double v) { f.law.lines[0].rho = v; }, [](const auto& f) { return !f.law.lines.empty(); }},
      {[](auto& f, double v) { f.law.ahead->x = v; }, [](const auto& f) { return f.law.ahead.has_value(); }},
      {[](auto& f, double v) { f.law.behind->x = v; },
       [](const auto& f) { return f.law.behind.has_value(); }},
      {[](auto& f, double v) { f.law.target->x = v; },
       [](const auto& f) { return f.law.target.has_value(); }},
  };
  for (const double bad : {kNaN, kInf, -kInf}) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      Observation o = sound(3);
      all[k].first(o.features, bad);
      EXPECT_FALSE(is_finite(o.features)) << k;
      ObservationGuard guard;
      const Observation& out = guard.checked(o);
      for (std::size_t j = 0; j < all.size(); ++j) {
        const bool same_feature = j == k || (j < 2 && k < 2);
        EXPECT_EQ(all[j].second(out.features), !same_feature) << k << ' ' << j;
      }
      EXPECT_EQ(out.features.lines.size(), 2u);
      EXPECT_TRUE(is_finite(out.features));
      EXPECT_THAT(guard.take_news(), Optional(HasSubstr("not seen")));
    }
  }
}

TEST(ObservationGuard, OnlyTheLineThatIsNotFiniteGoes) {
  const std::vector<std::function<void(features::LineFeature&)>> all{
      [](auto& l) { l.rho = kNaN; },       [](auto& l) { l.theta_rad = kInf; },
      [](auto& l) { l.curvature = kNaN; }, [](auto& l) { l.begin.x = kNaN; },
      [](auto& l) { l.end.y = -kInf; },    [](auto& l) { l.width = kNaN; },
  };
  for (const auto& spoil : all) {
    ObservationGuard guard;
    Observation o = sound(0);
    spoil(o.features.lines[0]);
    const Observation& out = guard.checked(o);
    ASSERT_EQ(out.features.lines.size(), 1u);
    EXPECT_EQ(out.features.lines[0].rho, 0.4);
    EXPECT_EQ(out.estimate.odometry_now.translation_m, o.estimate.odometry_now.translation_m);
  }
}

TEST(ObservationGuard, TheLastGoodEstimatesStandIn) {
  const std::vector<std::function<void(Observation&, double)>> all{
      [](auto& o, double v) { o.estimate.odometry_now.translation_m.x() = v; },
      [](auto& o, double v) { o.estimate.odometry_now.yaw_rad = v; },
      [](auto& o, double v) { o.estimate.odometry_at_capture.yaw_rad = v; },
      [](auto& o, double v) { o.estimate.height_m = v; },
      [](auto& o, double v) { o.estimate.capture_height_m = v; },
      [](auto& o, double v) { o.estimate.v_H_m_s.z() = v; },
      [](auto& o, double v) { o.estimate.height_age_s = v; },
      [](auto& o, double v) { o.estimate.velocity_age_s = v; },
  };
  for (const double bad : {kNaN, kInf}) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      ObservationGuard guard;
      guard.checked(sound(4));
      Observation o = sound(5);
      all[k](o, bad);
      const Observation& out = guard.checked(o);
      EXPECT_TRUE(is_finite(out.estimate)) << k;
      EXPECT_EQ(out.now, o.now) << "time goes on";
      EXPECT_EQ(out.captured, o.captured);
      EXPECT_EQ(out.estimate.odometry_now.translation_m, sound(4).estimate.odometry_now.translation_m) << k;
      EXPECT_EQ(out.estimate.height_m, sound(4).estimate.height_m) << k;
      EXPECT_EQ(out.estimate.v_H_m_s, sound(4).estimate.v_H_m_s) << k;
      EXPECT_EQ(out.features.lines.size(), 2u) << "what is seen counts";
      EXPECT_THAT(guard.take_news(), Optional(HasSubstr("last good ones"))) << k;
    }
  }
}

TEST(ObservationGuard, SaysForHowLongTheyHaveBeenBad) {
  ObservationGuard guard;
  guard.checked(sound(0));
  int told = 0;
  for (int k = 1; k <= 6; ++k) {
    Observation o = sound(k);
    o.estimate.height_m = kNaN;
    EXPECT_EQ(guard.checked(o).estimate.height_m, 0.5);
    EXPECT_NEAR(guard.bad_for_s(), 0.1 * (k - 1), 1e-9);
    told += guard.take_news() ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
  guard.checked(sound(7));
  EXPECT_EQ(guard.bad_for_s(), 0.0);
}

TEST(ObservationGuard, BadFeaturesAreNoBadEstimates) {
  ObservationGuard guard;
  Observation o = sound(1);
  o.features.lines[0].rho = kNaN;
  guard.checked(o);
  EXPECT_EQ(guard.bad_for_s(), 0.0);
  // and its estimates are the last good ones
  Observation bad = sound(2);
  bad.estimate.height_m = kNaN;
  EXPECT_EQ(guard.checked(bad).estimate.height_m, o.estimate.height_m);
}

TEST(ObservationGuard, IsFiniteWhenNothingGoodCameBefore) {
  ObservationGuard guard;
  Observation o = sound(0);
  o.estimate.v_H_m_s.setConstant(kNaN);
  EXPECT_TRUE(is_finite(guard.checked(o).estimate));
}

}  // namespace
}  // namespace lineservo::servo
