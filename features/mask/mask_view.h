#pragma once

#include <cstddef>
#include <cstdint>

namespace lineservo::features {

/// A binary image that someone else owns, 64 pixels to a word: pixel x of a row is bit x % 64 of its word
/// x / 64; bits past the width are zero.
struct MaskView {
  int width = 0;
  int height = 0;
  int words_per_row = 0;
  const std::uint64_t* words = nullptr;

  const std::uint64_t* row(int y) const {
    return words + static_cast<std::size_t>(y) * static_cast<std::size_t>(words_per_row);
  }
  bool at(int x, int y) const { return (row(y)[x >> 6] >> (x & 63)) & 1u; }
};

}  // namespace lineservo::features
