#include "features/mask/mask_filter.h"

#include <algorithm>
#include <cassert>

namespace lineservo::features {

MaskFilter::MaskFilter(int width, int height, Processor processor)
    : kernels_(&filter_kernels(processor)), width_(width), height_(height) {
  const PackedMask row(width, 1);
  stride_ = row.stride();
  inside_.resize(stride_ + 2);
  left_.resize(stride_ + 2);
  right_.resize(stride_ + 2);
  ring_.resize(stride_ * kRing * 3);

  const auto words = static_cast<std::size_t>(row.words_per_row());
  std::fill_n(inside_.begin() + 1, words, ~Word{0});
  inside_[words] = row.last_word_pixels();
  left_[0] = ~Word{0};
  right_[words] = ~row.last_word_pixels();
  std::fill(right_.begin() + static_cast<std::ptrdiff_t>(words) + 1, right_.end(), ~Word{0});
}

MaskFilter::Word* MaskFilter::ring_row(int y) {
  const auto repeated = static_cast<unsigned>(std::clamp(y, 0, height_ - 1));
  return ring_.data() + repeated % kRing * 3 * stride_;
}

FiveRows MaskFilter::rows_around(int y) {
  return {{ring_row(y - 2), ring_row(y - 1), ring_row(y), ring_row(y + 1), ring_row(y + 2)}};
}

template <typename Along, typename Across>
void MaskFilter::sweep(Along along, Across across) {
  for (int y = 0; y < height_ + 2; ++y) {
    if (y < height_) along(y);
    if (y >= 2) across(y - 2);
  }
}

void MaskFilter::median_5x5(const PackedMask& in, PackedMask& out) {
  assert(fits(in) && fits(out));
  const auto along = [&](int y) {
    kernels_->count(in.row(y).data(), in.at(0, y), in.at(width_ - 1, y), bits(), ring_row(y), stride_);
  };
  const auto across = [&](int y) { kernels_->majority(rows_around(y), bits(), out.row(y).data(), stride_); };
  sweep(along, across);
}

void MaskFilter::dilate_and_invert(const PackedMask& in, PackedMask& out) {
  const auto along = [&](int y) { kernels_->any_along(in.row(y).data(), ring_row(y), stride_); };
  const auto across = [&](int y) {
    kernels_->none_across(rows_around(y), bits(), out.row(y).data(), stride_);
  };
  sweep(along, across);
}

// Erosion is the dilation of the background: erode(M) = ¬ dilate(¬M).
void MaskFilter::close_5x5(const PackedMask& in, PackedMask& out) {
  assert(fits(in) && fits(out));
  dilate_and_invert(in, out);
  dilate_and_invert(out, out);
}

}  // namespace lineservo::features
