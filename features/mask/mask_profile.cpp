#include "features/mask/mask_profile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>

#include "features/mask/bit_block.h"

namespace lineservo::features {
namespace {

using Word = PackedMask::Word;

// Counts of 64 columns at once: bit x of digits[k] is binary digit k of the count of column x.
using ColumnDigits = std::array<Word, 17>;  // up to 65536 rows

// Adds two rows: digit 0 takes both in one full adder, the carry ripples on.
void count(Word a, Word b, ColumnDigits& digits) {
  const Word half = a ^ b;
  Word carry = (a & b) | (half & digits[0]);
  digits[0] ^= half;
  for (std::size_t k = 1; carry != 0; ++k) {
    const Word next = digits[k] & carry;
    digits[k] ^= carry;
    carry = next;
  }
}

ColumnDigits count_columns(const PackedMask& mask, int word) {
  ColumnDigits digits{};
  const auto at = static_cast<std::size_t>(word);
  int y = 0;
  for (; y + 1 < mask.height(); y += 2) count(mask.row(y)[at], mask.row(y + 1)[at], digits);
  if (y < mask.height()) count(mask.row(y)[at], 0, digits);
  return digits;
}

void write_columns(const ColumnDigits& digits, int first_column, std::vector<int>& columns) {
  const auto first = static_cast<std::size_t>(first_column);
  const std::size_t n = std::min<std::size_t>(PackedMask::kWordBits, columns.size() - first);
  std::fill_n(columns.begin() + first_column, n, 0);
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (digits[k] == 0) continue;
    for (std::size_t x = 0; x < n; ++x) columns[first + x] += static_cast<int>((digits[k] >> x) & 1U) << k;
  }
}

int count_row(std::span<const Word> row) {
  int sum = 0;
  for (const Word word : row) sum += std::popcount(word);
  return sum;
}

// Σ i nᵢ / Σ nᵢ
double mean_index(const std::vector<int>& counts, int total) {
  std::int64_t moment = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) moment += static_cast<std::int64_t>(i) * counts[i];
  return static_cast<double>(moment) / total;
}

}  // namespace

void profile_of(const PackedMask& mask, MaskProfile& profile) {
  profile.columns.resize(static_cast<std::size_t>(mask.width()));
  profile.rows.resize(static_cast<std::size_t>(mask.height()));
  for (int word = 0; word < mask.words_per_row(); ++word)
    write_columns(count_columns(mask, word), word * PackedMask::kWordBits, profile.columns);
  for (int y = 0; y < mask.height(); ++y) profile.rows[static_cast<std::size_t>(y)] = count_row(mask.row(y));
  profile.foreground = std::accumulate(profile.rows.begin(), profile.rows.end(), 0);
}

MaskProfile profile_of(const PackedMask& mask) {
  MaskProfile profile;
  profile_of(mask, profile);
  return profile;
}

std::optional<PixelPoint> centroid(const MaskProfile& profile) {
  if (profile.foreground == 0) return std::nullopt;
  return PixelPoint{mean_index(profile.columns, profile.foreground),
                    mean_index(profile.rows, profile.foreground)};
}

double foreground_ratio(const MaskProfile& profile) {
  return static_cast<double>(profile.foreground) /
         (static_cast<double>(profile.columns.size()) * static_cast<double>(profile.rows.size()));
}

}  // namespace lineservo::features
