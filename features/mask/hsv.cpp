#include "features/mask/hsv.h"

#include <algorithm>
#include <array>

namespace lineservo::features {
namespace {

constexpr int kShift = 12;  // fractional bits of the tables

// round(scale · 2¹² / i), with 0 at i = 0. No quotient lies half-way: that would take a factor 2¹³ in i.
constexpr std::array<int, 256> reciprocals(int scale) {
  std::array<int, 256> table{};
  for (int i = 1; i < 256; ++i) table[static_cast<std::size_t>(i)] = ((scale << kShift) * 2 + i) / (2 * i);
  return table;
}

constexpr std::array<int, 256> kSaturationOf = reciprocals(255);
constexpr std::array<int, 256> kHueOf = reciprocals(30);

int round_shift(int value) {
  return (value + (1 << (kShift - 1))) >> kShift;
}

}  // namespace

int raw_hue(int numerator, int chroma) {
  return round_shift(numerator * kHueOf[static_cast<std::size_t>(chroma)]);
}

int hue(int numerator, int chroma) {
  const int h = raw_hue(numerator, chroma);
  return h < 0 ? h + 180 : h;
}

int saturation(int chroma, int value) {
  return round_shift(chroma * kSaturationOf[static_cast<std::size_t>(value)]);
}

Hsv hsv_of(int b, int g, int r) {
  const int v = std::max({b, g, r});
  const int chroma = v - std::min({b, g, r});
  const int numerator = v == r ? g - b : v == g ? b - r + 2 * chroma : r - g + 4 * chroma;
  return {hue(numerator, chroma), saturation(chroma, v), v};
}

}  // namespace lineservo::features
