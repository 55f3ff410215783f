#include "features/mask/mask_filter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#include "features/mask/bit_block.h"

namespace lineservo::features {
namespace {

// The pixel k to the left and k to the right of each of the pixels that start at word.
template <int k>
Block left(const std::uint64_t* word) {
  return (load_block(word) << k) | (load_block(word - 1) >> (64 - k));
}
template <int k>
Block right(const std::uint64_t* word) {
  return (load_block(word) >> k) | (load_block(word + 1) << (64 - k));
}

// How many of the five pixels x − 2 … x + 2 are set, as three bits.
struct Count {
  Block ones, twos, fours;
};

Count count_five(const std::uint64_t* word) {
  const BitSum first = add(left<2>(word), left<1>(word), load_block(word));
  const BitSum second = add(first.sum, right<1>(word), right<2>(word));
  return {second.sum, first.carry ^ second.carry, first.carry & second.carry};
}

// Whether five counts of five add up to at least 13: a carry-save tree, weight by weight.
Block majority(const std::array<Count, 5>& c) {
  const BitSum one_a = add(c[0].ones, c[1].ones, c[2].ones);
  const BitSum one = add(one_a.sum, c[3].ones, c[4].ones);

  const BitSum two_a = add(c[0].twos, c[1].twos, c[2].twos);
  const BitSum two_b = add(c[3].twos, c[4].twos, one_a.carry);
  const BitSum two = add(two_a.sum, two_b.sum, one.carry);

  const BitSum four_a = add(c[0].fours, c[1].fours, c[2].fours);
  const BitSum four_b = add(c[3].fours, c[4].fours, two_a.carry);
  const BitSum four_c = add(four_a.sum, four_b.sum, two_b.carry);
  const Block four = four_c.sum ^ two.carry;

  // Up to three of the four carries of weight 8 are set: 25 < 32.
  const BitSum eight = add(four_a.carry, four_b.carry, four_c.carry);
  const Block last = four_c.sum & two.carry;
  const Block sixteen_or_more = eight.carry | (eight.sum & last);
  const Block eight_or_more = eight.sum | last;
  return sixteen_or_more | (eight_or_more & four & (two.sum | one.sum));  // 13 = 8 + 4 + 1
}

}  // namespace

MaskFilter::MaskFilter(int width, int height)
    : width_(width),
      height_(height),
      padded_words_(static_cast<std::size_t>((width + 127) / 128 * kBlockWords)),
      last_word_pixels_(PackedMask(width, 1).last_word_pixels()),
      line_(padded_words_ + 4),
      result_(padded_words_),
      ones_(padded_words_, height),
      twos_(padded_words_, height),
      fours_(padded_words_, height) {}

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

void MaskFilter::count_along_rows(const PackedMask& in) {
  for (int y = 0; y < height_; ++y) {
    load_row_repeating_ends(in.row(y));
    for (std::size_t i = 0; i < padded_words_; i += kBlockWords) {
      const Count count = count_five(line_.data() + 1 + i);
      store_block(ones_.row(y) + i, count.ones);
      store_block(twos_.row(y) + i, count.twos);
      store_block(fours_.row(y) + i, count.fours);
    }
  }
  for (Plane* plane : {&ones_, &twos_, &fours_}) {
    for (int y : {-2, -1}) std::copy_n(plane->row(0), padded_words_, plane->row(y));
    for (int y : {height_, height_ + 1}) std::copy_n(plane->row(height_ - 1), padded_words_, plane->row(y));
  }
}

void MaskFilter::median_5x5(const PackedMask& in, PackedMask& out) {
  assert(in.width() == width_ && in.height() == height_ && out.width() == width_ && out.height() == height_);
  count_along_rows(in);
  for (int y = 0; y < height_; ++y) {
    for (std::size_t i = 0; i < padded_words_; i += kBlockWords) {
      std::array<Count, 5> counts;
      for (int k = 0; k < 5; ++k)
        counts[static_cast<std::size_t>(k)] = {load_block(ones_.row(y + k - 2) + i),
                                               load_block(twos_.row(y + k - 2) + i),
                                               load_block(fours_.row(y + k - 2) + i)};
      store_block(&result_[i], majority(counts));
    }
    store_row(out.row(y));
  }
}

void MaskFilter::dilate(const PackedMask& in, PackedMask& out) {
  for (int y : {-2, -1, height_, height_ + 1}) std::fill_n(ones_.row(y), padded_words_, Word{0});
  for (int y = 0; y < height_; ++y) {
    load_row(in.row(y), 0, 0);
    for (std::size_t i = 0; i < padded_words_; i += kBlockWords) {
      const Word* at = line_.data() + 1 + i;
      store_block(ones_.row(y) + i, left<2>(at) | left<1>(at) | load_block(at) | right<1>(at) | right<2>(at));
    }
  }
  for (int y = 0; y < height_; ++y) {
    for (std::size_t i = 0; i < padded_words_; i += kBlockWords) {
      const auto at = [&](int dy) { return load_block(ones_.row(y + dy) + i); };
      store_block(&result_[i], at(-2) | at(-1) | at(0) | at(1) | at(2));
    }
    store_row(out.row(y));
  }
}

void MaskFilter::erode(const PackedMask& in, PackedMask& out) {
  for (int y : {-2, -1, height_, height_ + 1}) std::fill_n(ones_.row(y), padded_words_, ~Word{0});
  for (int y = 0; y < height_; ++y) {
    load_row(in.row(y), ~Word{0}, ~Word{0});
    for (std::size_t i = 0; i < padded_words_; i += kBlockWords) {
      const Word* at = line_.data() + 1 + i;
      store_block(ones_.row(y) + i, left<2>(at) & left<1>(at) & load_block(at) & right<1>(at) & right<2>(at));
    }
  }
  for (int y = 0; y < height_; ++y) {
    for (std::size_t i = 0; i < padded_words_; i += kBlockWords) {
      const auto at = [&](int dy) { return load_block(ones_.row(y + dy) + i); };
      store_block(&result_[i], at(-2) & at(-1) & at(0) & at(1) & at(2));
    }
    store_row(out.row(y));
  }
}

void MaskFilter::close_5x5(const PackedMask& in, PackedMask& out) {
  assert(in.width() == width_ && in.height() == height_ && out.width() == width_ && out.height() == height_);
  dilate(in, out);
  erode(out, out);
}

}  // namespace lineservo::features
