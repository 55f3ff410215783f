#include "features/mask/mask_filter.h"

#include <algorithm>
#include <cassert>

namespace lineservo::features {
namespace {

constexpr int kVectorBits = 256;

const FilterKernels& kernels_for([[maybe_unused]] Processor processor) {
#if defined(__x86_64__)
  if (processor == Processor::avx2) return kAvx2FilterKernels;
#endif
  return kPortableFilterKernels;
}

}  // namespace

MaskFilter::MaskFilter(int width, int height, Processor processor)
    : kernels_(&kernels_for(processor)),
      width_(width),
      height_(height),
      padded_words_(static_cast<std::size_t>((width + kVectorBits - 1) / kVectorBits) * kVectorBits /
                    PackedMask::kWordBits),
      last_word_pixels_(PackedMask(width, 1).last_word_pixels()),
      line_(padded_words_ + 2),
      ring_(padded_words_ * kRing * 3),
      result_(padded_words_) {}

MaskFilter::Word* MaskFilter::ring_row(int y, int digit) {
  return ring_.data() + static_cast<std::size_t>(clamped(y) % kRing * 3 + digit) * padded_words_;
}

CountRow MaskFilter::count_row(int y) {
  return {ring_row(y, 0), ring_row(y, 1), ring_row(y, 2)};
}

int MaskFilter::clamped(int y) const {
  return std::clamp(y, 0, height_ - 1);
}

// Copies a row to line_, with the bits outside of it on either side set to before and after.
void MaskFilter::load_row(std::span<const Word> row, Word before, Word after) {
  Word* line = line_.data() + 1;
  line[-1] = before;
  std::copy(row.begin(), row.end(), line);
  line[row.size() - 1] |= after & ~last_word_pixels_;
  std::fill(line + row.size(), line_.data() + line_.size(), after);
}

void MaskFilter::load_row_repeating_ends(std::span<const Word> row) {
  const bool first = row.front() & 1U;
  const bool last = (row.back() >> ((width_ - 1) % PackedMask::kWordBits)) & 1U;
  load_row(row, Word{0} - Word{first}, Word{0} - Word{last});
}

void MaskFilter::store_row(std::span<Word> row) const {
  std::copy_n(result_.begin(), row.size(), row.begin());
  row.back() &= last_word_pixels_;
}

template <typename Along, typename Across>
void MaskFilter::sweep(Along along, Across across) {
  for (int y = 0; y < height_ + 2; ++y) {
    if (y < height_) along(y);
    if (y >= 2) across(y - 2);
  }
}

void MaskFilter::median_5x5(const PackedMask& in, PackedMask& out) {
  assert(in.width() == width_ && in.height() == height_ && out.width() == width_ && out.height() == height_);
  const auto along = [&](int y) {
    load_row_repeating_ends(in.row(y));
    kernels_->count(line_.data() + 1, count_row(y), padded_words_);
  };
  const auto across = [&](int y) {
    const FiveCounts rows = {
        {count_row(y - 2), count_row(y - 1), count_row(y), count_row(y + 1), count_row(y + 2)}};
    kernels_->majority(rows, result_.data(), padded_words_);
    store_row(out.row(y));
  };
  sweep(along, across);
}

void MaskFilter::morph(const PackedMask& in, PackedMask& out, Word outside,
                       decltype(FilterKernels::any_along) along_kernel,
                       decltype(FilterKernels::any_across) across_kernel) {
  const auto along = [&](int y) {
    load_row(in.row(y), outside, outside);
    along_kernel(line_.data() + 1, ring_row(y), padded_words_);
  };
  const auto across = [&](int y) {
    across_kernel({{ring_row(y - 2), ring_row(y - 1), ring_row(y), ring_row(y + 1), ring_row(y + 2)}},
                  result_.data(), padded_words_);
    store_row(out.row(y));
  };
  sweep(along, across);
}

void MaskFilter::close_5x5(const PackedMask& in, PackedMask& out) {
  assert(in.width() == width_ && in.height() == height_ && out.width() == width_ && out.height() == height_);
  morph(in, out, Word{0}, kernels_->any_along, kernels_->any_across);
  morph(out, out, ~Word{0}, kernels_->all_along, kernels_->all_across);
}

}  // namespace lineservo::features
