#include "apps/recording/digest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <type_traits>

#include "apps/recording/tick_fields.h"

namespace lineservo::apps {
namespace {

using features::FrameFeatures;

TEST(Digest, OfATickHangsOnEveryValue) {
  std::set<std::string> digests = {digest(TickInput{})};
  std::size_t fields = 0;
  TickInput any;
  for_each_field(any, [&](const char*, auto&) { ++fields; });
  for (std::size_t k = 0; k < fields; ++k) {
    TickInput input;
    std::size_t at = 0;
    for_each_field(input, [&](const char*, auto& value) {
      if (at++ != k) return;
      using Value = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, bool>) value = !value;
      if constexpr (std::is_same_v<Value, double>) value = std::nextafter(value, 10.0);
      if constexpr (std::is_same_v<Value, servo::Time>) value += servo::Time(1);
    });
    EXPECT_TRUE(digests.insert(digest(input)).second) << "field " << k;
  }
}

TEST(Digest, OfFeaturesHangsOnEveryValue) {
  using Change = std::function<void(FrameFeatures&)>;
  const auto line = [](FrameFeatures& f) -> features::LineFeature& { return f.lines.emplace_back(); };
  const std::vector<Change> changes = {
      [](FrameFeatures&) {},
      [&](FrameFeatures& f) { line(f); },
      [&](FrameFeatures& f) { line(f).rho = 1e-300; },
      [&](FrameFeatures& f) { line(f).theta_rad = 1.0; },
      [&](FrameFeatures& f) { line(f).covariance(1, 0) = 0.5; },
      [&](FrameFeatures& f) { line(f).width = 1.0; },
      [&](FrameFeatures& f) { line(f).quality = 1.0; },
      [&](FrameFeatures& f) { line(f).begin.x = 1.0; },
      [&](FrameFeatures& f) { line(f).end.y = 1.0; },
      [&](FrameFeatures& f) { line(f).curvature = 1.0; },
      [](FrameFeatures& f) { f.law.lines.emplace_back(); },
      [](FrameFeatures& f) { f.junction.emplace(); },
      [](FrameFeatures& f) { f.junction.emplace().centre.y = 1.0; },
      [](FrameFeatures& f) { f.junction.emplace().quality = 1.0; },
      [](FrameFeatures& f) {
        f.junction.emplace().arms.push_back({0.5, 0.0});
      },
      [](FrameFeatures& f) {
        f.junction.emplace().arms.push_back({0.0, 0.5});
      },
      [](FrameFeatures& f) { f.code.raw = features::JunctionCode::cross; },
      [](FrameFeatures& f) { f.code.held = features::JunctionCode::cross; },
      [](FrameFeatures& f) { f.code.smoothed = features::JunctionCode::cross; },
      [](FrameFeatures& f) { f.code.line_ends_ahead = true; },
      [](FrameFeatures& f) {
        f.line_end = {0.0, 0.0};
      },
      [](FrameFeatures& f) {
        f.centroid_px = {0.0, 0.0};
      },
      [](FrameFeatures& f) { f.marker_pixels = 1; },
      [](FrameFeatures& f) {
        f.start_marker = {0.0, 0.0};
      },
      [](FrameFeatures& f) { f.foreground_ratio = 0.1; },
      [](FrameFeatures& f) {
        f.law.centroid = {0.0, 0.0};
      },
      [](FrameFeatures& f) {
        f.law.ahead = {0.0, 0.0};
      },
      [](FrameFeatures& f) {
        f.law.behind = {0.0, 0.0};
      },
      [](FrameFeatures& f) {
        f.law.target = {0.0, 0.0};
      },
  };
  std::set<std::string> digests;
  for (const Change& change : changes) {
    FrameFeatures features;
    change(features);
    digests.insert(digest(features));
  }
  EXPECT_EQ(digests.size(), changes.size());
}

TEST(Digest, OfACommandTellsItsKinds) {
  const std::set<std::string> digests = {
      digest(row_of(servo::VelocityCommand{})), digest(row_of(servo::AttitudeCommand{})),
      digest(row_of(servo::LandCommand{})), digest(row_of(servo::VelocityCommand{0.0, 0.0, 0.0, 0.1}))};
  EXPECT_EQ(digests.size(), 4u);
}

TEST(Digest, AllThatIsNotANumberIsEqual) {
  TickInput a, b;
  a.estimate.height_m = std::numeric_limits<double>::quiet_NaN();
  b.estimate.height_m = -std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(digest(a), digest(b));
}

}  // namespace
}  // namespace lineservo::apps
