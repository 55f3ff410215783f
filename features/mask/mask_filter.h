#pragma once

#include <vector>

#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// The two filters of topology §2.1 on packed masks of one size, 64 pixels an operation. Each is split into
/// a pass along the rows and one across them; the intermediate rows are kept between frames.
class MaskFilter {
 public:
  MaskFilter(int width, int height);

  /// Foreground where at least 13 of the 25 pixels around are; outside, the border pixel is repeated. The
  /// same as cv::medianBlur of size 5.
  void median_5x5(const PackedMask& in, PackedMask& out);

  /// Dilation, then erosion, by a 5×5 square; what lies outside influences neither. The same as
  /// cv::morphologyEx(MORPH_CLOSE). in and out may be the same mask.
  void close_5x5(const PackedMask& in, PackedMask& out);

 private:
  using Word = PackedMask::Word;

  /// Words of an image with two rows more above and below, rows padded to whole vectors.
  struct Plane {
    Plane(std::size_t row_words, int height)
        : stride(row_words), words(row_words * (static_cast<std::size_t>(height) + 4)) {}
    Word* row(int y) { return words.data() + static_cast<std::size_t>(y + 2) * stride; }
    std::size_t stride;
    std::vector<Word> words;
  };

  void load_row(std::span<const Word> row, Word before, Word after);
  void load_row_repeating_ends(std::span<const Word> row);
  void store_row(std::span<Word> row) const;
  void count_along_rows(const PackedMask& in);
  void dilate(const PackedMask& in, PackedMask& out);
  void erode(const PackedMask& in, PackedMask& out);

  int width_, height_;
  std::size_t padded_words_;
  Word last_word_pixels_;
  std::vector<Word> line_;    // one row with a word more before and after it
  std::vector<Word> result_;  // one row
  Plane ones_, twos_, fours_;
};

}  // namespace lineservo::features
