#pragma once

#include <cstddef>
#include <cstdint>

namespace lineservo::features {

/// Three binary digits of up to 7, for each pixel of a row: how many of five neighbours are set.
struct CountRow {
  std::uint64_t *ones = nullptr, *twos = nullptr, *fours = nullptr;
};

struct FiveCounts {
  CountRow row[5];
};
struct FiveRows {
  const std::uint64_t* row[5];
};

/// The row operations of MaskFilter. Rows are padded to multiples of four words; `line` has a word before its
/// first and one after its last, which hold what lies outside.
struct FilterKernels {
  using Word = std::uint64_t;

  /// Along a row, over x − 2 … x + 2.
  void (*count)(const Word* line, CountRow out, std::size_t words);
  void (*any_along)(const Word* line, Word* out, std::size_t words);
  void (*all_along)(const Word* line, Word* out, std::size_t words);
  /// Across five rows.
  void (*majority)(const FiveCounts& rows, Word* out, std::size_t words);
  void (*any_across)(const FiveRows& rows, Word* out, std::size_t words);
  void (*all_across)(const FiveRows& rows, Word* out, std::size_t words);
};

/// Each of the same source, compiled for 128-bit registers (which every x86-64 has) and for AVX2.
extern const FilterKernels kPortableFilterKernels;
#if defined(__x86_64__)
extern const FilterKernels kAvx2FilterKernels;
#endif

}  // namespace lineservo::features
