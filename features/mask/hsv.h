#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace lineservo::features {

// The rounded fixed-point arithmetic of cv::cvtColor(COLOR_BGR2HSV) on 8-bit images, bit for bit.
// With v = max(b, g, r) and chroma c = v − min(b, g, r):
//   s = 255 c / v,   h = 30 n / c (half degrees), where the numerator n is
//   g − b when red is the largest, else b − r + 2c when green is, else r − g + 4c.

/// A colour as 8-bit OpenCV writes it: hue in half degrees 0…179, saturation and value 0…255.
struct Hsv {
  int h = 0;
  int s = 0;
  int v = 0;
};

namespace hsv_detail {

inline constexpr int kShift = 12;  // fractional bits of the tables

// round(scale · 2¹² / i), with 0 at i = 0. No quotient lies half-way: that would take a factor 2¹³ in i.
constexpr std::array<int, 256> reciprocals(int scale) {
  std::array<int, 256> table{};
  for (int i = 1; i < 256; ++i) table[static_cast<std::size_t>(i)] = ((scale << kShift) * 2 + i) / (2 * i);
  return table;
}

inline constexpr std::array<int, 256> kSaturationOf = reciprocals(255);
inline constexpr std::array<int, 256> kHueOf = reciprocals(30);

constexpr int round_shift(int value) {
  return (value + (1 << (kShift - 1))) >> kShift;
}

}  // namespace hsv_detail

/// Hue of numerator n ∈ [−c, 5c] and chroma c ∈ [0, 255]; 180 is added to negative ones.
constexpr int hue(int numerator, int chroma) {
  const int h = hsv_detail::round_shift(numerator * hsv_detail::kHueOf[static_cast<std::size_t>(chroma)]);
  return h < 0 ? h + 180 : h;
}

/// Saturation of chroma c ≤ v.
constexpr int saturation(int chroma, int value) {
  return hsv_detail::round_shift(chroma * hsv_detail::kSaturationOf[static_cast<std::size_t>(value)]);
}

/// Of a colour whose largest channel is v.
constexpr int hue_numerator(int b, int g, int r, int v, int chroma) {
  return v == r ? g - b : v == g ? b - r + 2 * chroma : r - g + 4 * chroma;
}

constexpr Hsv hsv_of(int b, int g, int r) {
  const int v = std::max(std::max(b, g), r);
  const int chroma = v - std::min(std::min(b, g), r);
  return {hue(hue_numerator(b, g, r, v, chroma), chroma), saturation(chroma, v), v};
}

}  // namespace lineservo::features
