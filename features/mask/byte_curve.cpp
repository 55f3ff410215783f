#include "features/mask/byte_curve.h"

#include <algorithm>

namespace lineservo::features {
namespace {

struct Tables {
  std::array<int, 16> high{}, low{};
};

// T ≤ high + low ≤ T + 1 for all values that matter is a system of difference constraints in (high, −low):
// Bellman–Ford relaxation finds a solution within one round a node, or there is none.
std::optional<Tables> solve(const std::array<int, 256>& values, const std::bitset<256>& matters) {
  Tables t;
  for (int round = 0; round <= 32; ++round) {
    bool changed = false;
    for (std::size_t x = 0; x < 256; ++x) {
      if (!matters[x]) continue;
      int& high = t.high[x / 16];
      int& low = t.low[x % 16];
      // Both only ever shrink high and −low, as shortest distances do.
      if (high + low > values[x] + 1) high = values[x] + 1 - low, changed = true;
      if (high + low < values[x]) low = values[x] - high, changed = true;
    }
    if (!changed) return t;
  }
  return std::nullopt;
}

bool fits_bytes(const std::array<int, 16>& table) {
  return std::all_of(table.begin(), table.end(), [](int v) { return v >= 0 && v <= 255; });
}

void shift_to_zero(Tables& t) {
  const int lowest = *std::min_element(t.low.begin(), t.low.end());
  for (int& v : t.low) v -= lowest;
  for (int& v : t.high) v += lowest;
}

ByteCurve pack(const Tables& t, const std::array<int, 256>& values, const std::bitset<256>& matters) {
  ByteCurve curve;
  for (std::size_t i = 0; i < 16; ++i) {
    curve.high[i] = static_cast<std::uint8_t>(t.high[i]);
    curve.low[i] = static_cast<std::uint8_t>(t.low[i]);
  }
  for (std::size_t x = 0; x < 256; ++x) {
    const std::size_t h = x / 16, l = x % 16;
    if (!matters[x] || t.high[h] + t.low[l] == values[x]) continue;
    auto& bits = h < 8 ? curve.bits_lower : curve.bits_upper;
    bits[l] = static_cast<std::uint8_t>(bits[l] | (1U << (h % 8)));
  }
  return curve;
}

bool passes_through(const ByteCurve& curve, const std::array<int, 256>& values,
                    const std::bitset<256>& matters) {
  for (std::size_t x = 0; x < 256; ++x)
    if (matters[x] && curve.at(static_cast<int>(x)) != values[x]) return false;
  return true;
}

}  // namespace

int ByteCurve::at(int x) const {
  const auto h = static_cast<std::size_t>(x / 16), l = static_cast<std::size_t>(x % 16);
  const int bit = ((h < 8 ? bits_lower : bits_upper)[l] >> (h % 8)) & 1;
  return high[h] + low[l] - bit;
}

std::optional<ByteCurve> fit_byte_curve(const std::array<int, 256>& values, const std::bitset<256>& matters) {
  std::optional<Tables> tables = solve(values, matters);
  if (!tables.has_value()) return std::nullopt;
  shift_to_zero(*tables);
  // A group of 16 in which nothing matters may have been left below zero.
  for (int& high : tables->high) high = std::max(high, 0);
  if (!fits_bytes(tables->high) || !fits_bytes(tables->low)) return std::nullopt;
  const ByteCurve curve = pack(*tables, values, matters);
  return passes_through(curve, values, matters) ? std::optional(curve) : std::nullopt;
}

}  // namespace lineservo::features
