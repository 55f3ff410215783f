#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

namespace lineservo::features {

/// A function of a byte that vector code looks up without a gather: with x = 16 h + l,
///   T(x) = high[h] + low[l] − bit(h, l),   bit ∈ {0, 1}.
/// Any function that is a straight line up to rounding fits; high, low and the bits are 16-entry tables,
/// which is what one byte shuffle reads.
struct ByteCurve {
  std::array<std::uint8_t, 16> high{}, low{};
  std::array<std::uint8_t, 16> bits_lower{};  ///< of l: bit h, for h = 0…7
  std::array<std::uint8_t, 16> bits_upper{};  ///< of l: bit h − 8, for h = 8…15

  int at(int x) const;
};

/// The curve through the values that matter, or nothing when there is none.
std::optional<ByteCurve> fit_byte_curve(const std::array<int, 256>& values, const std::bitset<256>& matters);

}  // namespace lineservo::features
