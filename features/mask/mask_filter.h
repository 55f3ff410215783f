#pragma once

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
  static constexpr unsigned kRing = 8;  // rows: the five in use, rounded up so that the index is a mask

  Word* ring_row(int y);
  FiveRows rows_around(int y);
  RowBits bits() const { return {inside_.data(), left_.data(), right_.data()}; }
  bool fits(const PackedMask& mask) const { return mask.width() == width_ && mask.height() == height_; }

  /// Calls along(y) for every row, and across(y) as soon as along has been through rows up to y + 2.
  template <typename Along, typename Across>
  void sweep(Along along, Across across);
  /// The background of the dilation of a mask.
  void dilate_and_invert(const PackedMask& in, PackedMask& out);

  const FilterKernels* kernels_;
  int width_, height_;
  std::size_t stride_;
  std::vector<Word> inside_, left_, right_;  // see RowBits
  std::vector<Word> ring_;                   // kRing rows of three digits
};

}  // namespace lineservo::features
