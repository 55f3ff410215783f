#include "features/mask/avx2_classifier.h"

#if defined(__x86_64__)

#include <algorithm>

namespace lineservo::features {
namespace {

constexpr int kGroup = 32;               // pixels
constexpr std::size_t kGroupWords = 96;  // of a resized row: 3 channels, A and B
constexpr int kWeightSplit = 64;

using namespace vector_test;
using Gather = Avx2Classifier::Gather;

// ---- Plans ------------------------------------------------------------------------------------------------

// The k-th pair (k = 2 · quad + half) of vector A or B of a group starts at this pixel of the group.
int first_pixel(int vector, int quad, int half) {
  return 16 * half + 8 * vector + 2 * quad;
}

const BilinearTap& padded(const std::vector<BilinearTap>& taps, int x) {
  return taps[std::min(static_cast<std::size_t>(x), taps.size() - 1)];
}

bool near(const BilinearTap& a, const BilinearTap& b) {
  return b.i1 - a.i0 <= 4;
}  // 5 pixels are 15 bytes

bool all_near(const std::vector<BilinearTap>& taps) {
  for (std::size_t x = 0; x < taps.size(); x += 2)
    if (!near(taps[x], padded(taps, static_cast<int>(x + 1)))) return false;
  return true;
}

struct PairPlan {
  int first = 0, second = 0;
  std::array<std::uint8_t, 16> order{};
};

// Reads never pass the end of the row: they start earlier there, and the shuffle makes up for it.
PairPlan plan_pair(const BilinearTap& a, const BilinearTap& b, int row_bytes, bool near_pairs) {
  PairPlan plan;
  plan.first = std::min(3 * a.i0, row_bytes - (near_pairs ? 16 : 8));
  plan.second = near_pairs ? plan.first : std::min(3 * b.i0, row_bytes - 8);
  const int second_base = near_pairs ? 0 : 8;
  plan.order.fill(0x80);
  for (int channel = 0; channel < 3; ++channel) {
    const std::array<int, 4> source = {3 * a.i0 + channel - plan.first, 3 * a.i1 + channel - plan.first,
                                       3 * b.i0 + channel - plan.second + second_base,
                                       3 * b.i1 + channel - plan.second + second_base};
    for (std::size_t i = 0; i < 4; ++i)
      plan.order[static_cast<std::size_t>(4 * channel) + i] = static_cast<std::uint8_t>(source[i]);
  }
  return plan;
}

void put_weights(Gather& gather, int position, const BilinearTap& tap) {
  const auto at = static_cast<std::size_t>(2 * position);
  gather.weight_high[at] = static_cast<std::int8_t>(tap.w0 / kWeightSplit);
  gather.weight_high[at + 1] = static_cast<std::int8_t>(tap.w1 / kWeightSplit);
  gather.weight_low[at] = static_cast<std::int8_t>(tap.w0 % kWeightSplit);
  gather.weight_low[at + 1] = static_cast<std::int8_t>(tap.w1 % kWeightSplit);
}

Gather plan_vector(const std::vector<BilinearTap>& taps, int group, int vector, int row_bytes,
                   bool near_pairs) {
  Gather gather;
  for (int quad = 0; quad < 4; ++quad) {
    for (int half = 0; half < 2; ++half) {
      const int x = group * kGroup + first_pixel(vector, quad, half);
      const BilinearTap &a = padded(taps, x), &b = padded(taps, x + 1);
      const PairPlan pair = plan_pair(a, b, row_bytes, near_pairs);
      const auto k = static_cast<std::size_t>(2 * quad + half);
      gather.first[k] = pair.first;
      gather.second[k] = pair.second;
      gather.order[k] = pair.order;
      put_weights(gather, 8 * half + 2 * quad, a);
      put_weights(gather, 8 * half + 2 * quad + 1, b);
    }
  }
  return gather;
}

std::vector<Gather> plan_row(const std::vector<BilinearTap>& taps, int row_bytes, bool near_pairs) {
  std::vector<Gather> gathers;
  const int groups = (static_cast<int>(taps.size()) + kGroup - 1) / kGroup;
  for (int group = 0; group < groups; ++group)
    for (int vector = 0; vector < 2; ++vector)
      gathers.push_back(plan_vector(taps, group, vector, row_bytes, near_pairs));
  return gathers;
}

// ---- Horizontal half of the bilinear sum ------------------------------------------------------------------

LINESERVO_AVX2_INLINE __m256i load(const void* p) {
  return _mm256_load_si256(static_cast<const __m256i*>(p));
}

template <bool kNearPairs>
LINESERVO_AVX2_INLINE __m128i load_pair(const std::uint8_t* pixels, const Gather& gather, std::size_t k) {
  if constexpr (kNearPairs)
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(pixels + gather.first[k]));
  else
    return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(pixels + gather.first[k])),
                              _mm_loadl_epi64(reinterpret_cast<const __m128i*>(pixels + gather.second[k])));
}

// Two pixels a half: bytes B0B1 B0B1 G0G1 G0G1 R0R1 R0R1 0000.
template <bool kNearPairs>
LINESERVO_AVX2_INLINE __m256i load_quad(const std::uint8_t* pixels, const Gather& gather, std::size_t quad) {
  const __m256i raw =
      _mm256_inserti128_si256(_mm256_castsi128_si256(load_pair<kNearPairs>(pixels, gather, 2 * quad)),
                              load_pair<kNearPairs>(pixels, gather, 2 * quad + 1), 1);
  return _mm256_shuffle_epi8(raw, load(&gather.order[2 * quad]));
}

// (p0 w0 + p1 w1) >> 4 with w = 64 high + low: the high part is a multiple of 16, so only the low part
// rounds. 255 · (63 + 63) still fits a signed word.
LINESERVO_AVX2_INLINE __m256i weigh(__m256i pairs, __m256i weight_high, __m256i weight_low) {
  const __m256i high = _mm256_slli_epi16(_mm256_maddubs_epi16(pairs, weight_high), 2);
  const __m256i low = _mm256_srli_epi16(_mm256_maddubs_epi16(pairs, weight_low), 4);
  return _mm256_add_epi16(high, low);
}

template <bool kNearPairs>
LINESERVO_AVX2_INLINE void resize_vector(const std::uint8_t* pixels, const Gather& gather,
                                         std::int16_t* out) {
  const __m256i q0 = load_quad<kNearPairs>(pixels, gather, 0), q1 = load_quad<kNearPairs>(pixels, gather, 1);
  const __m256i q2 = load_quad<kNearPairs>(pixels, gather, 2), q3 = load_quad<kNearPairs>(pixels, gather, 3);
  const __m256i bg01 = _mm256_unpacklo_epi32(q0, q1), bg23 = _mm256_unpacklo_epi32(q2, q3);
  const __m256i r01 = _mm256_unpackhi_epi32(q0, q1), r23 = _mm256_unpackhi_epi32(q2, q3);
  const __m256i high = load(&gather.weight_high), low = load(&gather.weight_low);
  auto* to = reinterpret_cast<__m256i*>(out);
  _mm256_store_si256(to, weigh(_mm256_unpacklo_epi64(bg01, bg23), high, low));
  _mm256_store_si256(to + 2, weigh(_mm256_unpackhi_epi64(bg01, bg23), high, low));
  _mm256_store_si256(to + 4, weigh(_mm256_unpacklo_epi64(r01, r23), high, low));
}

template <bool kNearPairs>
LINESERVO_AVX2 void resize_row(const std::uint8_t* pixels, const Gather* gathers, std::size_t groups,
                               std::int16_t* out) {
  for (std::size_t group = 0; group < groups; ++group, out += kGroupWords) {
    resize_vector<kNearPairs>(pixels, gathers[2 * group], out);
    resize_vector<kNearPairs>(pixels, gathers[2 * group + 1], out + 16);
  }
}

// ---- Vertical half, colour test ---------------------------------------------------------------------------

struct RowWeights {
  __m256i upper, lower;
};

LINESERVO_AVX2_INLINE __m256i blend_words(const std::int16_t* upper, const std::int16_t* lower,
                                          const RowWeights& weights) {
  const __m256i sum = _mm256_add_epi16(_mm256_mulhi_epi16(load(upper), weights.upper),
                                       _mm256_mulhi_epi16(load(lower), weights.lower));
  return _mm256_srli_epi16(_mm256_add_epi16(sum, _mm256_set1_epi16(2)), 2);
}

// One channel of a group, in the order of the image.
LINESERVO_AVX2_INLINE __m256i blend_bytes(const std::int16_t* upper, const std::int16_t* lower,
                                          const RowWeights& weights) {
  return _mm256_packus_epi16(blend_words(upper, lower, weights),
                             blend_words(upper + 16, lower + 16, weights));
}

// The bits of the pixels x … x + 31; the lower half of a word comes first.
inline void put_group(PackedMask::Word* row, int x, PackedMask::Word bits) {
  if (x % PackedMask::kWordBits == 0)
    row[x / PackedMask::kWordBits] = bits;
  else
    row[x / PackedMask::kWordBits] |= bits << kGroup;
}

// Returns the number of marker pixels among the first width.
LINESERVO_AVX2 int classify_row(const std::int16_t* upper, const std::int16_t* lower, const BilinearTap& tap,
                                const RedSectorTest& test, const PlainLimits& limits, int width,
                                PackedMask::Word* path, PackedMask::Word* marker) {
  const RowWeights weights{_mm256_set1_epi16(tap.w0), _mm256_set1_epi16(tap.w1)};
  const TestTables test_tables = tables(test, limits);
  int marker_pixels = 0;
  for (int x = 0; x < width; x += kGroup, upper += kGroupWords, lower += kGroupWords) {
    const __m256i b = blend_bytes(upper, lower, weights);
    const __m256i g = blend_bytes(upper + 32, lower + 32, weights);
    const __m256i r = blend_bytes(upper + 64, lower + 64, weights);
    const GroupMasks masks = classify_group(b, g, r, test_tables);
    const std::uint32_t inside = width - x >= kGroup ? ~0U : (1U << (width - x)) - 1U;
    marker_pixels += __builtin_popcount(masks.marker & inside);
    put_group(path, x, masks.path & inside);
    put_group(marker, x, masks.marker & inside);
  }
  return marker_pixels;
}

std::int16_t* aligned(std::vector<std::int16_t>& row) {
  const auto address = reinterpret_cast<std::uintptr_t>(row.data());
  return row.data() + ((32 - address % 32) % 32) / sizeof(std::int16_t);
}

}  // namespace

Avx2Classifier::Avx2Classifier(const SegmenterOptions& options, const RedSectorTest& test,
                               cv::Size frame_size)
    : test_(test),
      limits_(vector_test::plain_limits(test)),
      width_(options.width_px),
      rows_(bilinear_rows(frame_size.height, options.height_px)) {
  const std::vector<BilinearTap> columns = bilinear_columns(frame_size.width, options.width_px);
  pairs_are_near_ = all_near(columns);
  gathers_ = plan_row(columns, 3 * frame_size.width, pairs_are_near_);
  for (auto& row : cache_) row.resize(gathers_.size() / 2 * kGroupWords + 16);
}

int Avx2Classifier::classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) {
  cached_y_.fill(-1);
  int marker_pixels = 0;
  for (std::size_t y = 0; y < rows_.size(); ++y) {
    const std::int16_t* upper = resized_row(frame, rows_[y].i0);
    const std::int16_t* lower = resized_row(frame, rows_[y].i1);
    marker_pixels +=
        classify_row(upper, lower, rows_[y], test_, limits_, width_, path.row(static_cast<int>(y)).data(),
                     marker.row(static_cast<int>(y)).data());
  }
  return marker_pixels;
}

// Neighbouring rows differ in parity, so that the two of a blend never evict each other.
const std::int16_t* Avx2Classifier::resized_row(const cv::Mat& frame, int y) {
  const auto slot = static_cast<std::size_t>(y % 2);
  std::int16_t* row = aligned(cache_[slot]);
  if (cached_y_[slot] != y) {
    const auto resize = pairs_are_near_ ? resize_row<true> : resize_row<false>;
    resize(frame.ptr<std::uint8_t>(y), gathers_.data(), gathers_.size() / 2, row);
    cached_y_[slot] = y;
  }
  return row;
}

}  // namespace lineservo::features

#endif
