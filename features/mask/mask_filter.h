#pragma once

#include <array>
#include <vector>

#include "features/mask/filter_kernels.h"
#include "features/mask/packed_mask.h"
#include "features/mask/processor.h"

namespace lineservo::features {

/// The two filters of topology §2.1 on packed masks of one size. Each is a pass along the rows, whose last
/// five results are kept, and a pass across those five. Rows beyond the top or bottom repeat the border row;
/// for dilation and erosion that is the same as leaving them out.
class MaskFilter {
 public:
  MaskFilter(int width, int height, Processor processor = best_processor());

  /// Foreground where at least 13 of the 25 pixels around are; outside, the border pixel is repeated. The
  /// same as cv::medianBlur of size 5. in and out may be the same mask.
  void median_5x5(const PackedMask& in, PackedMask& out);

  /// Dilation, then erosion, by a 5×5 square; what lies outside influences neither. The same as
  /// cv::morphologyEx(MORPH_CLOSE). in and out may be the same mask.
  void close_5x5(const PackedMask& in, PackedMask& out);

 private:
  using Word = PackedMask::Word;
  static constexpr int kRing = 5;  // rows

  Word* ring_row(int y, int digit = 0);
  CountRow count_row(int y);
  int clamped(int y) const;

  void load_row(std::span<const Word> row, Word before, Word after);
  void load_row_repeating_ends(std::span<const Word> row);
  void store_row(std::span<Word> row) const;

  /// Calls along(y) for every row, and across(y) as soon as along has been through rows up to y + 2.
  template <typename Along, typename Across>
  void sweep(Along along, Across across);
  /// along on each row with what lies outside set to `outside`, across on the results.
  void morph(const PackedMask& in, PackedMask& out, Word outside, decltype(FilterKernels::any_along) along,
             decltype(FilterKernels::any_across) across);

  const FilterKernels* kernels_;
  int width_, height_;
  std::size_t padded_words_;
  Word last_word_pixels_;
  std::vector<Word> line_;    // one row with a word more before and after it
  std::vector<Word> ring_;    // kRing rows of three digits
  std::vector<Word> result_;  // one row
};

}  // namespace lineservo::features
