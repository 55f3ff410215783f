#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "features/mask/mask_view.h"

namespace lineservo::features {

/// A binary image, 64 pixels to a word: pixel (x, y) is bit x mod 64 of word x / 64 of row y.
/// Every row starts on a word. Bits past the width are always zero; who writes through `row` keeps it so.
///
/// Rows lie `stride` words apart, a multiple of eight, and at least one word of zeros stands before and after
/// every row: vector code reads whole rows and their neighbouring words without looking for the ends.
class PackedMask {
 public:
  using Word = std::uint64_t;
  static constexpr int kWordBits = 64;

  PackedMask() = default;
  /// All background. Throws std::invalid_argument unless both sides are 1 to 65535 px.
  PackedMask(int width, int height);
  /// Foreground where the pixel is not zero. Throws std::invalid_argument unless the image is CV_8UC1.
  static PackedMask from_mat(const cv::Mat& image);

  int width() const { return width_; }
  int height() const { return height_; }
  int words_per_row() const { return words_per_row_; }
  /// Words from the start of one row to the start of the next.
  std::size_t stride() const { return stride_; }

  bool at(int x, int y) const { return (words_[index(x, y)] >> (x % kWordBits)) & 1U; }
  void set(int x, int y, bool foreground = true);

  std::span<const Word> row(int y) const {
    return {words_.data() + index(0, y), static_cast<std::size_t>(words_per_row_)};
  }
  std::span<Word> row(int y) {
    return {words_.data() + index(0, y), static_cast<std::size_t>(words_per_row_)};
  }
  /// Which bits of a row's last word are pixels.
  Word last_word_pixels() const { return ~Word{0} >> (words_per_row_ * kWordBits - width_); }

  /// The same pixels, borrowed.
  MaskView view() const { return {width_, height_, static_cast<int>(stride_), row(0).data()}; }

  /// Adds the foreground of a mask of the same size.
  PackedMask& operator|=(const PackedMask& other);

  /// Number of foreground pixels.
  int count() const;
  /// CV_8UC1 with 255 for foreground, as cv::inRange writes it.
  cv::Mat to_mat() const;

  friend bool operator==(const PackedMask&, const PackedMask&) = default;

 private:
  static constexpr std::size_t kAlignedWords = 8;

  // The first row starts after one aligned group of zeros.
  std::size_t index(int x, int y) const {
    return kAlignedWords + static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x / kWordBits);
  }

  int width_ = 0;
  int height_ = 0;
  int words_per_row_ = 0;
  std::size_t stride_ = 0;
  std::vector<Word> words_;
};

}  // namespace lineservo::features
