#pragma once

#include <cstddef>
#include <cstdint>

#include "features/mask/processor.h"

namespace lineservo::features {

/// Five rows of a packed mask, the middle one being filtered.
struct FiveRows {
  const std::uint64_t* row[5];
};

/// Which bits of a row of words are pixels, and which lie to its left and right. From the word before the
/// row (so element 0 is that of word −1) to the word after it.
struct RowBits {
  const std::uint64_t *inside, *left, *right;
};

/// The row operations of MaskFilter, on rows of PackedMask::stride() words.
struct FilterKernels {
  using Word = std::uint64_t;

  /// Counts along a row over x − 2 … x + 2; what lies outside repeats the first and the last pixel. Writes
  /// the binary digits of each pixel's count as three rows, one after the other: ones, twos, fours.
  void (*count)(const Word* row, bool first, bool last, RowBits bits, Word* out, std::size_t words);
  /// Where five counts add up to 13 or more.
  void (*majority)(const FiveRows& counts, RowBits bits, Word* out, std::size_t words);
  /// Dilation along a row; outside is background.
  void (*any_along)(const Word* row, Word* out, std::size_t words);
  /// The background of a dilation across five rows.
  void (*none_across)(const FiveRows& rows, RowBits bits, Word* out, std::size_t words);
  /// Foreground pixels.
  int (*population)(const Word* row, std::size_t words);
};

/// Each of the same source, compiled for 128-bit registers (which every x86-64 has), for AVX2 and for
/// AVX-512.
extern const FilterKernels kPortableFilterKernels;
#if defined(__x86_64__)
extern const FilterKernels kAvx2FilterKernels, kAvx512FilterKernels;
#endif

const FilterKernels& filter_kernels(Processor processor);

}  // namespace lineservo::features
