#include "features/line/thinning.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/features/line/drawn_stripe.h"

namespace lineservo::features {
namespace {

using test::draw_mask;
using test::stripe_through;
using test::TestRandom;

/// The algorithm as the paper has it, pixel by pixel.
bool textbook_pass(PackedMask& mask, int parity) {
  const auto at = [&mask](int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width() && y < mask.height() && mask.at(x, y);
  };
  std::vector<std::pair<int, int>> gone;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (!at(x, y)) continue;
      const bool p[8] = {at(x, y - 1), at(x + 1, y - 1), at(x + 1, y), at(x + 1, y + 1),
                         at(x, y + 1), at(x - 1, y + 1), at(x - 1, y), at(x - 1, y - 1)};
      int set = 0, rises = 0;
      for (int k = 0; k < 8; ++k) {
        set += p[k];
        rises += int{!p[k] && p[(k + 1) % 8]};
      }
      const bool held = parity == 0 ? (p[0] && p[2] && p[4]) || (p[2] && p[4] && p[6])
                                    : (p[0] && p[2] && p[6]) || (p[0] && p[4] && p[6]);
      if (set >= 2 && set <= 6 && rises == 1 && !held) gone.emplace_back(x, y);
    }
  }
  for (const auto& [x, y] : gone) mask.set(x, y, false);
  return !gone.empty();
}

PackedMask textbook(PackedMask mask) {
  bool changed = true;
  while (changed) {
    const bool first = textbook_pass(mask, 0);
    const bool second = textbook_pass(mask, 1);
    changed = first || second;
  }
  return mask;
}

PackedMask thinned(PackedMask mask) {
  Thinner().thin(mask);
  return mask;
}

PackedMask noise(int width, int height, double share, std::uint64_t seed) {
  TestRandom random(seed);
  PackedMask mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (random.uniform(0.0, 1.0) < share) mask.set(x, y);
  return mask;
}

TEST(Thinning, SamePixelsAsTheTextbookOnNoiseOfAnyWidth) {
  for (const int width : {1, 2, 63, 64, 65, 127, 128, 130, 257})
    for (const double share : {0.1, 0.5, 0.8, 0.95}) {
      const PackedMask mask = noise(width, 70, share, static_cast<std::uint64_t>(width * 100 + share * 10));
      EXPECT_EQ(thinned(mask), textbook(mask)) << width << " " << share;
    }
}

TEST(Thinning, SamePixelsAsTheTextbookOnStripesAndCrosses) {
  for (const double theta_deg : {0.0, 3.0, 30.0, 45.0, 88.0, -50.0}) {
    const PackedMask one = draw_mask({300, 200}, {stripe_through(150, 100, theta_deg, 37)});
    EXPECT_EQ(thinned(one), textbook(one)) << theta_deg;
    const PackedMask two = draw_mask(
        {300, 200}, {stripe_through(150, 100, theta_deg, 37), stripe_through(120, 90, theta_deg + 80.0, 22)});
    EXPECT_EQ(thinned(two), textbook(two)) << theta_deg;
  }
}

TEST(Thinning, SamePixelsAsTheTextbookWhereAllIsPaintedOrNothing) {
  const PackedMask nothing(100, 50), all = noise(100, 50, 2.0, 1);
  EXPECT_EQ(thinned(nothing), nothing);
  EXPECT_EQ(thinned(all), textbook(all));
  EXPECT_GT(thinned(all).count(), 0);
}

TEST(Thinning, MasksWiderThan64WordsToo) {
  PackedMask mask(64 * 65 + 7, 24);
  for (int x = 0; x < mask.width(); ++x)
    for (int y = 6; y < 17; ++y) mask.set(x, y);
  EXPECT_EQ(thinned(mask), textbook(mask));
}

TEST(Thinning, AnUprightStripeLeavesItsMiddleColumn) {
  const PackedMask skeleton = thinned(draw_mask({200, 120}, {{100.0, 0.0, 21.0}}));
  for (int y = 15; y < 105; ++y) {
    int count = 0;
    for (int x = 0; x < 200; ++x)
      if (skeleton.at(x, y)) {
        ++count;
        EXPECT_NEAR(x, 100, 1);
      }
    EXPECT_EQ(count, 1) << y;
  }
}

TEST(Thinning, AThinnerCanBeUsedForMasksOfAnySizeInTurn) {
  Thinner thinner;
  for (const int width : {300, 20, 130}) {
    PackedMask mask = noise(width, 40, 0.8, 7);
    const PackedMask expected = textbook(mask);
    thinner.thin(mask);
    EXPECT_EQ(mask, expected);
  }
}

}  // namespace
}  // namespace lineservo::features
