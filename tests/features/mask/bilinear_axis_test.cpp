#include "features/mask/bilinear_axis.h"

#include <gtest/gtest.h>

namespace lineservo::features {
namespace {

void expect_tap(const BilinearTap& tap, int i0, int i1, int w0, int w1) {
  EXPECT_EQ(tap.i0, i0);
  EXPECT_EQ(tap.i1, i1);
  EXPECT_EQ(tap.w0, w0);
  EXPECT_EQ(tap.w1, w1);
}

TEST(BilinearAxis, TheSameSizeIsTheIdentity) {
  for (const auto& taps : {bilinear_columns(20, 20), bilinear_rows(20, 20)})
    for (int i = 0; i < 20; ++i)
      expect_tap(taps[static_cast<std::size_t>(i)], i, std::min(i + 1, 19), 2048, 0);
}

TEST(BilinearAxis, HalvingAveragesPairs) {
  const auto taps = bilinear_columns(40, 20);
  for (int i = 0; i < 20; ++i) expect_tap(taps[static_cast<std::size_t>(i)], 2 * i, 2 * i + 1, 1024, 1024);
}

// x_in = 1.6 (x + ½) − ½: 0.3, 1.9, 3.5, 5.1, 6.7, and the same again 8 pixels on.
TEST(BilinearAxis, VgaColumnsRepeatEveryFive) {
  const auto taps = bilinear_columns(640, 400);
  expect_tap(taps[0], 0, 1, 1434, 614);
  expect_tap(taps[1], 1, 2, 205, 1843);
  expect_tap(taps[2], 3, 4, 1024, 1024);
  expect_tap(taps[3], 5, 6, 1843, 205);
  expect_tap(taps[4], 6, 7, 614, 1434);
  expect_tap(taps[5], 8, 9, 1434, 614);
}

// Doubling: x_in = −0.25 at the first and n − 0.75 at the last sample, both outside.
TEST(BilinearAxis, TheBorderDiffersBetweenColumnsAndRows) {
  const auto columns = bilinear_columns(16, 32), rows = bilinear_rows(16, 32);
  expect_tap(columns.front(), 0, 1, 2048, 0);
  expect_tap(columns.back(), 15, 15, 2048, 0);
  expect_tap(rows.front(), 0, 0, 512, 1536);
  expect_tap(rows.back(), 15, 15, 1536, 512);
}

}  // namespace
}  // namespace lineservo::features
