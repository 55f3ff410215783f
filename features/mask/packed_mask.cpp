#include "features/mask/packed_mask.h"

#include <bit>
#include <cassert>
#include <stdexcept>

namespace lineservo::features {

PackedMask::PackedMask(int width, int height)
    : width_(width), height_(height), words_per_row_((width + kWordBits - 1) / kWordBits) {
  constexpr int kMaxSide = 65535;
  if (width < 1 || width > kMaxSide || height < 1 || height > kMaxSide)
    throw std::invalid_argument("mask: both sides must be 1 to 65535 px");
  // The words of a row, one of zeros at least, rounded up.
  stride_ = (static_cast<std::size_t>(words_per_row_) / kAlignedWords + 1) * kAlignedWords;
  words_.resize(index(0, height) + kAlignedWords);
}

PackedMask PackedMask::from_mat(const cv::Mat& image) {
  if (image.type() != CV_8UC1) throw std::invalid_argument("mask: the image must have one 8-bit channel");
  PackedMask mask(image.cols, image.rows);
  for (int y = 0; y < image.rows; ++y) {
    const auto* pixels = image.ptr<std::uint8_t>(y);
    for (int x = 0; x < image.cols; ++x)
      mask.words_[mask.index(x, y)] |= Word{pixels[x] != 0} << (x % kWordBits);
  }
  return mask;
}

void PackedMask::set(int x, int y, bool foreground) {
  const Word bit = Word{1} << (x % kWordBits);
  Word& word = words_[index(x, y)];
  word = foreground ? word | bit : word & ~bit;
}

PackedMask& PackedMask::operator|=(const PackedMask& other) {
  assert(width_ == other.width_ && height_ == other.height_);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  return *this;
}

int PackedMask::count() const {
  int sum = 0;
  for (const Word word : words_) sum += std::popcount(word);
  return sum;
}

cv::Mat PackedMask::to_mat() const {
  cv::Mat image(height_, width_, CV_8UC1);
  for (int y = 0; y < height_; ++y) {
    auto* pixels = image.ptr<std::uint8_t>(y);
    for (int x = 0; x < width_; ++x) pixels[x] = at(x, y) ? 255 : 0;
  }
  return image;
}

}  // namespace lineservo::features
