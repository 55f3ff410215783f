#include "features/mask/byte_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lineservo::features {
namespace {

std::array<int, 256> line(double slope, double offset) {
  std::array<int, 256> values{};
  for (std::size_t x = 0; x < 256; ++x)
    values[x] = static_cast<int>(std::ceil(slope * static_cast<double>(x) + offset));
  return values;
}

void expect_exact(const std::array<int, 256>& values) {
  const auto curve = fit_byte_curve(values, std::bitset<256>().set());
  ASSERT_TRUE(curve.has_value());
  for (int x = 0; x < 256; ++x) EXPECT_EQ(curve->at(x), values[static_cast<std::size_t>(x)]) << x;
}

TEST(ByteCurve, HoldsEveryRoundedStraightLine) {
  for (double slope = 0.0; slope < 0.93; slope += 0.013)
    for (const double offset : {0.0, 0.25, 7.5, 17.0}) expect_exact(line(slope, offset));
}

TEST(ByteCurve, HoldsAConstant) {
  expect_exact(line(0.0, 255.0));
}

TEST(ByteCurve, RefusesWhatIsNoLine) {
  std::array<int, 256> parabola{};
  for (std::size_t x = 0; x < 256; ++x) parabola[x] = static_cast<int>(x * x / 256);
  EXPECT_FALSE(fit_byte_curve(parabola, std::bitset<256>().set()).has_value());
}

TEST(ByteCurve, RefusesValuesThatAreNoBytes) {
  EXPECT_FALSE(fit_byte_curve(line(1.5, 0.0), std::bitset<256>().set()).has_value());
  EXPECT_FALSE(fit_byte_curve(line(0.0, -3.0), std::bitset<256>().set()).has_value());
}

TEST(ByteCurve, ValuesThatDoNotMatterMayBeAnything) {
  std::array<int, 256> values = line(0.5, 0.0);
  std::bitset<256> matters;
  for (std::size_t x = 0; x < 256; ++x)
    x >= 100 ? void(matters.set(x)) : void(values[x] = x % 2 ? 5000 : -5000);
  const auto curve = fit_byte_curve(values, matters);
  ASSERT_TRUE(curve.has_value());
  for (int x = 100; x < 256; ++x) EXPECT_EQ(curve->at(x), values[static_cast<std::size_t>(x)]) << x;
}

}  // namespace
}  // namespace lineservo::features
