#include "vehicle/floor/floor_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;

LightOptions swinging() {
  LightOptions options;
  options.low = 0.4;
  options.high = 1.3;
  return options;
}

TEST(FloorLight, IsPlainByItself) {
  const FloorLight light({}, 1);
  EXPECT_TRUE(light.is_plain());
  EXPECT_EQ(light.at({3.0, 4.0}).factor, 1.0);
  EXPECT_EQ(light.at({3.0, 4.0}).glare, 0.0);
}

// It takes both bounds, and on average the middle of them: S(t) has mean 1/2.
TEST(FloorLight, SwingsBetweenItsBounds) {
  const FloorLight light(swinging(), 5);
  double lowest = 9.0, highest = 0.0, sum = 0.0;
  int count = 0;
  for (double x = 0.0; x < 40.0; x += 0.05)
    for (double y = 0.0; y < 40.0; y += 0.5, ++count) {
      const double factor = light.at({x, y}).factor;
      lowest = std::min(lowest, factor);
      highest = std::max(highest, factor);
      sum += factor;
    }
  EXPECT_GE(lowest, 0.4);
  EXPECT_NEAR(lowest, 0.4, 1e-3);
  EXPECT_LE(highest, 1.3);
  EXPECT_NEAR(highest, 1.3, 1e-3);
  EXPECT_NEAR(sum / count, 0.85, 0.02);
}

TEST(FloorLight, AGlareFallsOffAsItsFormulaSays) {
  LightOptions options;
  options.glare = 0.8;
  options.glare_every_m = 3.0;
  FloorLight light(options, 2);
  light.look_near({0.0, 0.0, 0.5}, 6.0);
  ASSERT_FALSE(light.glares_W().empty());
  const Vector2d middle = light.glares_W()[0];
  for (const double share : {0.0, 0.3, 0.7, 1.0}) {
    const double expected = 0.8 * std::pow(1.0 - share * share, 2);
    EXPECT_NEAR(light.at(middle + Vector2d(0.25 * share, 0.0)).glare, expected, 1e-9);
  }
}

TEST(FloorLight, GlaresStayWhereTheyAreWhenTheVehicleMoves) {
  LightOptions options;
  options.glare = 0.8;
  FloorLight here(options, 2), there(options, 2);
  here.look_near({1.0, 1.0, 0.5}, 3.0);
  there.look_near({2.0, 0.5, 0.7}, 3.0);
  for (double x = 0.5; x < 2.5; x += 0.1)
    for (double y = 0.0; y < 2.0; y += 0.1) EXPECT_EQ(here.at({x, y}).glare, there.at({x, y}).glare);
}

TEST(FloorLight, TheShadowGoesWithTheVehicle) {
  LightOptions options;
  options.shadow = 0.6;
  options.shadow_offset = 0.0;
  FloorLight light(options, 2);
  for (const Vector2d& foot : {Vector2d(1.0, 2.0), Vector2d(-3.0, 0.5)}) {
    light.look_near({foot.x(), foot.y(), 0.5}, 1.0);
    EXPECT_NEAR(light.at(foot).factor, 0.4, 1e-12);
    EXPECT_NEAR(light.at(foot + Vector2d(0.0, 0.175)).factor, 1.0 - 0.6 * 0.75 * 0.75, 1e-12);
    EXPECT_EQ(light.at(foot + Vector2d(0.36, 0.0)).factor, 1.0);
  }
}

TEST(FloorLight, RefusesWhatIsOutOfBounds) {
  LightOptions options;
  options.high = 2.1;
  EXPECT_THROW(FloorLight(options, 1), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
