#include "vehicle/floor/decals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/vehicle/floor/test_layouts.h"
#include "vehicle/floor/floor_truth.h"

namespace lineservo::vehicle {
namespace {

using Eigen::Vector2d;

WearOptions worn(double share) {
  WearOptions options;
  options.worn_share = share;
  return options;
}

bool is_under(const std::vector<const PaintShape*>& shapes, const Vector2d& p_W) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const PaintShape* s) { return s->paints(p_W); });
}

// The share of a straight line's paint that is missing, from points 2 cm apart.
double missing_share(const WearOptions& options, double width_m, double length_m, std::uint64_t seed) {
  Decals decals(test::single_line({0, 0}, {length_m, 0}, width_m), options, seed);
  int points = 0, missing = 0;
  for (double x = 0.01; x < length_m; x += 0.02) {
    decals.look_near({x, 0.0}, width_m);
    for (double y = -0.5 * width_m + 0.005; y < 0.5 * width_m; y += 0.01) {
      ++points;
      missing += is_under(decals.holes(), {x, y}) ? 1 : 0;
    }
  }
  return static_cast<double>(missing) / points;
}

// 600 blotches on 36 m² of paint: the share is known to ± 0.01.
TEST(Decals, TheShareOfWornPaintIsThatAskedFor) {
  EXPECT_NEAR(missing_share(worn(0.25), 0.36, 100.0, 1), 0.25, 0.03);
  EXPECT_NEAR(missing_share(worn(0.5), 0.36, 100.0, 2), 0.5, 0.04);
  EXPECT_NEAR(missing_share(worn(0.25), 0.05, 100.0, 3), 0.25, 0.03);
  EXPECT_EQ(missing_share(worn(0.0), 0.36, 5.0, 4), 0.0);
}

TEST(Decals, BlotchesAreThatOfTheSeedWhateverWasLookedAtBefore) {
  const Layout layout = test::warehouse();
  Decals there(layout, worn(0.25), 7), wandered(layout, worn(0.25), 7), other(layout, worn(0.25), 8);
  there.look_near({9.0, 2.8}, 0.7);
  for (const Vector2d& p : {Vector2d(0.6, 0.6), Vector2d(14.0, 7.0), Vector2d(9.0, 2.8)})
    wandered.look_near(p, 0.7);
  other.look_near({9.0, 2.8}, 0.7);
  ASSERT_EQ(there.holes().size(), wandered.holes().size());
  ASSERT_GT(there.holes().size(), 5U);
  for (std::size_t i = 0; i < there.holes().size(); ++i)
    EXPECT_EQ(there.holes()[i]->borders[0].centre_W, wandered.holes()[i]->borders[0].centre_W);
  EXPECT_NE(there.holes()[0]->borders[0].centre_W, other.holes()[0]->borders[0].centre_W);
}

// 30 m of line with one gap in each 3 m: runs of 0.1 m, whole across, none within 0.3 m of a node.
TEST(Decals, GapsHaveTheirLengthAndStayClearOfNodes) {
  WearOptions options;
  options.gap_m = 0.1;
  Decals decals(test::single_line({0, 0}, {30, 0}, 0.05), options, 1);
  double gap_m = 0.0;
  int gaps = 0;
  bool was_in = false;
  for (double x = 0.0005; x < 30.0; x += 0.001) {
    decals.look_near({x, 0.0}, 0.1);
    const bool is_in = is_under(decals.holes(), {x, 0.0});
    EXPECT_EQ(is_in, is_under(decals.holes(), {x, 0.0249}));
    EXPECT_FALSE(is_in && (x < 0.3 || x > 29.7));
    gap_m += is_in ? 0.001 : 0.0;
    gaps += is_in && !was_in ? 1 : 0;
    was_in = is_in;
  }
  EXPECT_EQ(gaps, 10);
  EXPECT_NEAR(gap_m / gaps, 0.1, 0.002);
}

// Some 330 spots.
TEST(Decals, DirtCoversItsShareOfFloorAndPaint) {
  WearOptions options;
  options.dirt_share = 0.02;
  Decals decals(test::warehouse(), options, 3);
  decals.look_near({8.0, 4.0}, 4.5);
  int points = 0, dirty = 0;
  for (double x = 5.0; x < 11.0; x += 0.03)
    for (double y = 1.0; y < 7.0; y += 0.03, ++points) dirty += is_under(decals.on_top(), {x, y}) ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(dirty) / points, 0.02, 0.005);
}

TEST(Decals, ObjectsLieBesideTheLines) {
  WearOptions options;
  options.objects_per_m2 = 3.0;
  const Layout layout = test::warehouse();
  Decals decals(layout, options, 3);
  decals.look_near({9.0, 4.0}, 3.0);
  EXPECT_GT(decals.on_top().size(), 20U);
  for (double x = 6.0; x < 12.0; x += 0.02)
    for (double y = 1.0; y < 7.0; y += 0.02)
      if (distance_to_paint_m(layout, {x, y}) < 0.02) {
        ASSERT_FALSE(is_under(decals.on_top(), {x, y}));
      }
}

TEST(Decals, EachSwitchesByItself) {
  const Layout layout = test::warehouse();
  EXPECT_TRUE(Decals(layout, {}, 1).is_none());
  WearOptions all = worn(0.25), dirt_only;
  all.gap_m = 0.1;
  all.dirt_share = dirt_only.dirt_share = 0.05;
  Decals both(layout, all, 1), one(layout, dirt_only, 1);
  both.look_near({9.0, 4.0}, 1.0);
  one.look_near({9.0, 4.0}, 1.0);
  EXPECT_TRUE(one.holes().empty());
  ASSERT_EQ(one.on_top().size(), both.on_top().size());
  EXPECT_EQ(one.on_top()[0]->borders[0].centre_W, both.on_top()[0]->borders[0].centre_W);
}

TEST(Decals, RefusesWhatIsOutOfBounds) {
  EXPECT_THROW(Decals(test::warehouse(), worn(1.0), 1), std::invalid_argument);
  EXPECT_THROW(Decals(test::warehouse(), worn(std::nan("")), 1), std::invalid_argument);
}

}  // namespace
}  // namespace lineservo::vehicle
