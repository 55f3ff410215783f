#include "features/mask/mask_profile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <numeric>

#include "features/mask/filter_kernels.h"

namespace lineservo::features {
namespace {

using Word = PackedMask::Word;

// Counts of 64 columns at once: bit x of digits[k] is binary digit k of the count of column x.
using ColumnDigits = std::array<Word, 16>;  // up to 65535 rows

// Adds 2ᵏ in the columns of carry.
void ripple(Word carry, std::size_t k, ColumnDigits& digits) {
  for (; carry != 0; ++k) {
    const Word next = digits[k] & carry;
    digits[k] ^= carry;
    carry = next;
  }
}

// digit + a + b = digit' + 2 carry, for each bit by itself; returns the carry.
Word add(Word& digit, Word a, Word b) {
  const Word half = a ^ b;
  const Word carry = (a & b) | (half & digit);
  digit ^= half;
  return carry;
}

// Eight rows at a time through a carry-save tree, so that only every eighth carry ripples on.
ColumnDigits count_columns(const PackedMask& mask, int word) {
  ColumnDigits digits{};
  const std::size_t stride = mask.stride();
  const Word* at = mask.row(0).data() + word;
  int y = 0;
  for (; y + 8 <= mask.height(); y += 8, at += 8 * stride) {
    const Word twos_a = add(digits[0], at[0], at[stride]);
    const Word twos_b = add(digits[0], at[2 * stride], at[3 * stride]);
    const Word twos_c = add(digits[0], at[4 * stride], at[5 * stride]);
    const Word twos_d = add(digits[0], at[6 * stride], at[7 * stride]);
    const Word fours_a = add(digits[1], twos_a, twos_b);
    const Word fours_b = add(digits[1], twos_c, twos_d);
    ripple(add(digits[2], fours_a, fours_b), 3, digits);
  }
  for (; y < mask.height(); ++y, at += stride) ripple(*at, 0, digits);
  return digits;
}

// Σ 2ᵏ (bit x of digits[k]) for the 8 columns from first on, one in each lane.
std::array<std::uint16_t, 8> counts_of_eight(const ColumnDigits& digits, int first) {
  using Lanes = std::uint16_t __attribute__((vector_size(16)));
  const Lanes bits = {1, 2, 4, 8, 16, 32, 64, 128};
  Lanes sum{};
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (digits[k] == 0) continue;
    const auto byte = static_cast<std::uint16_t>((digits[k] >> first) & 0xFFU);
    const auto weight = static_cast<std::uint16_t>(1U << k);
    sum += reinterpret_cast<Lanes>((bits & byte) == bits) & weight;
  }
  std::array<std::uint16_t, 8> counts;
  std::memcpy(counts.data(), &sum, sizeof sum);
  return counts;
}

void write_columns(const ColumnDigits& digits, std::size_t first_column, std::vector<int>& columns) {
  for (int x = 0; x < PackedMask::kWordBits; x += 8) {
    const std::size_t first = first_column + static_cast<std::size_t>(x);
    if (first >= columns.size()) return;
    const auto counts = counts_of_eight(digits, x);
    std::copy_n(counts.begin(), std::min<std::size_t>(8, columns.size() - first),
                columns.begin() + static_cast<std::ptrdiff_t>(first));
  }
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
    write_columns(count_columns(mask, word), static_cast<std::size_t>(word) * PackedMask::kWordBits,
                  profile.columns);
  const FilterKernels& kernels = filter_kernels(best_processor());
  for (int y = 0; y < mask.height(); ++y)
    profile.rows[static_cast<std::size_t>(y)] = kernels.population(mask.row(y).data(), mask.stride());
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
