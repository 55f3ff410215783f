#include "features/mask/avx512_classifier.h"

#if defined(__x86_64__)

#include <algorithm>

#define LINESERVO_AVX512 __attribute__((target("avx512f,avx512bw,avx512vl,avx512vbmi,popcnt")))
#define LINESERVO_AVX512_INLINE \
  __attribute__((target("avx512f,avx512bw,avx512vl,avx512vbmi,popcnt"), always_inline)) inline

namespace lineservo::features {
namespace {

using namespace vector_test;
using Gather = Avx512Classifier::Gather;

constexpr int kStep = 16;                 // pixels
constexpr int kGroup = 4 * kStep;         // pixels: a word of the mask
constexpr std::size_t kGroupWords = 192;  // of a resized row: four steps of blue and green, then red
constexpr int kRedStart = 128;
constexpr int kWindow = 128;  // bytes
constexpr int kWeightSplit = 64;

// ---- Plans ------------------------------------------------------------------------------------------------

const BilinearTap& padded(const std::vector<BilinearTap>& taps, int x) {
  return taps[std::min(static_cast<std::size_t>(x), taps.size() - 1)];
}

void put_pixel(Gather& gather, int position, const BilinearTap& tap) {
  const auto at = static_cast<std::size_t>(2 * position);
  const int left = 3 * tap.i0 - gather.first, right = 3 * tap.i1 - gather.first;
  gather.blue_green[at] = static_cast<std::uint8_t>(left);
  gather.blue_green[at + 1] = static_cast<std::uint8_t>(right);
  gather.blue_green[at + 32] = static_cast<std::uint8_t>(left + 1);
  gather.blue_green[at + 33] = static_cast<std::uint8_t>(right + 1);
  gather.red[at] = static_cast<std::uint8_t>(left + 2);
  gather.red[at + 1] = static_cast<std::uint8_t>(right + 2);
  gather.weight_high[at] = static_cast<std::int8_t>(tap.w0 / kWeightSplit);
  gather.weight_high[at + 1] = static_cast<std::int8_t>(tap.w1 / kWeightSplit);
  gather.weight_low[at] = static_cast<std::int8_t>(tap.w0 % kWeightSplit);
  gather.weight_low[at + 1] = static_cast<std::int8_t>(tap.w1 % kWeightSplit);
}

// Reads never pass the end of the row: they start earlier there.
std::vector<Gather> plan_row(const std::vector<BilinearTap>& taps, int row_bytes) {
  std::vector<Gather> gathers;
  for (int x = 0; x < static_cast<int>(taps.size()); x += kStep) {
    Gather& gather = gathers.emplace_back();
    gather.first = std::min(3 * padded(taps, x).i0, row_bytes - kWindow);
    for (int k = 0; k < kStep; ++k) put_pixel(gather, k, padded(taps, x + k));
  }
  return gathers;
}

// ---- Horizontal half of the bilinear sum ------------------------------------------------------------------

// As weigh() of the AVX2 classifier: (p0 w0 + p1 w1) >> 4.
LINESERVO_AVX512_INLINE __m512i weigh(__m512i pairs, __m512i weight_high, __m512i weight_low) {
  const __m512i high = _mm512_slli_epi16(_mm512_maddubs_epi16(pairs, weight_high), 2);
  const __m512i low = _mm512_srli_epi16(_mm512_maddubs_epi16(pairs, weight_low), 4);
  return _mm512_add_epi16(high, low);
}

LINESERVO_AVX512_INLINE __m512i twice(const std::array<std::int8_t, 32>& weights) {
  return _mm512_broadcast_i64x4(_mm256_load_si256(reinterpret_cast<const __m256i*>(weights.data())));
}

LINESERVO_AVX512 void resize_row(const std::uint8_t* pixels, const Gather* gathers, std::size_t steps,
                                 std::int16_t* out) {
  for (std::size_t step = 0; step < steps; ++step) {
    const Gather& gather = gathers[step];
    const __m512i near = _mm512_loadu_si512(pixels + gather.first);
    const __m512i far = _mm512_loadu_si512(pixels + gather.first + 64);
    const __m512i high = twice(gather.weight_high), low = twice(gather.weight_low);
    const __m512i blue_green =
        _mm512_permutex2var_epi8(near, _mm512_load_si512(gather.blue_green.data()), far);
    const __m512i red = _mm512_permutex2var_epi8(near, _mm512_load_si512(gather.red.data()), far);
    std::int16_t* group = out + step / 4 * kGroupWords;
    const std::size_t place = step % 4;
    _mm512_store_si512(group + 32 * place, weigh(blue_green, high, low));
    _mm256_store_si256(reinterpret_cast<__m256i*>(group + kRedStart + 16 * place),
                       _mm512_castsi512_si256(weigh(red, high, low)));
  }
}

// ---- Vertical half, colour test ---------------------------------------------------------------------------

struct RowWeights {
  __m512i upper, lower;
};

LINESERVO_AVX512_INLINE __m512i blend_words(const std::int16_t* upper, const std::int16_t* lower,
                                            const RowWeights& weights) {
  const __m512i sum = _mm512_add_epi16(_mm512_mulhi_epi16(_mm512_load_si512(upper), weights.upper),
                                       _mm512_mulhi_epi16(_mm512_load_si512(lower), weights.lower));
  return _mm512_srli_epi16(_mm512_add_epi16(sum, _mm512_set1_epi16(2)), 2);
}

/// The lower bytes of 64 words, in an order.
LINESERVO_AVX512_INLINE __m512i blend_bytes(const std::int16_t* upper, const std::int16_t* lower,
                                            const RowWeights& weights, __m512i order) {
  return _mm512_permutex2var_epi8(blend_words(upper, lower, weights), order,
                                  blend_words(upper + 32, lower + 32, weights));
}

struct GroupBytes {
  __m512i b, g, r;
};

struct PackOrders {
  __m512i steps;     // of two steps, blue of both and then green of both
  __m512i straight;  // word by word
};

LINESERVO_AVX512_INLINE GroupBytes blend_group(const std::int16_t* upper, const std::int16_t* lower,
                                               const RowWeights& weights, const PackOrders& orders) {
  const __m512i first = blend_bytes(upper, lower, weights, orders.steps);
  const __m512i second = blend_bytes(upper + 64, lower + 64, weights, orders.steps);
  return {_mm512_shuffle_i64x2(first, second, 0x44), _mm512_shuffle_i64x2(first, second, 0xEE),
          blend_bytes(upper + kRedStart, lower + kRedStart, weights, orders.straight)};
}

struct WordMasks {
  std::uint64_t path = 0, marker = 0;
};

// What plain_test() cannot tell takes the exact test, one half after the other.
LINESERVO_AVX512_INLINE WordMasks classify_exactly(const GroupBytes& p, const TestTables& test) {
  const GroupMasks low = classify_group(_mm512_castsi512_si256(p.b), _mm512_castsi512_si256(p.g),
                                        _mm512_castsi512_si256(p.r), test);
  const GroupMasks high = classify_group(_mm512_extracti64x4_epi64(p.b, 1), _mm512_extracti64x4_epi64(p.g, 1),
                                         _mm512_extracti64x4_epi64(p.r, 1), test);
  return {low.path | std::uint64_t{high.path} << 32, low.marker | std::uint64_t{high.marker} << 32};
}

struct PlainBounds {
  __m512i v_least, chroma_least, v_min, plain_floor;
  __mmask64 plain_path;
};

LINESERVO_AVX512_INLINE PlainBounds plain_bounds(const RedSectorTest& test, const PlainLimits& limits) {
  return {_mm512_set1_epi8(static_cast<char>(limits.v_least)),
          _mm512_set1_epi8(static_cast<char>(limits.chroma_least)),
          _mm512_set1_epi8(static_cast<char>(test.path.v_min)),
          _mm512_set1_epi8(limits.pale_is_floor ? -1 : 0), limits.plain_green_is_path ? ~__mmask64{0} : 0};
}

// plain_test() of 64 pixels; the exact one where that leaves any open.
LINESERVO_AVX512_INLINE WordMasks classify_word(const GroupBytes& p, const PlainBounds& bounds,
                                                const TestTables& test) {
  const __m512i zero = _mm512_setzero_si512();
  const __m512i v = _mm512_max_epu8(_mm512_max_epu8(p.b, p.g), p.r);
  const __m512i chroma = _mm512_sub_epi8(v, _mm512_min_epu8(_mm512_min_epu8(p.b, p.g), p.r));
  const __m512i half_v = _mm512_avg_epu8(v, zero), quarter_v = _mm512_avg_epu8(half_v, zero);
  const __m512i three_eighths_v = _mm512_avg_epu8(quarter_v, half_v);
  const __m512i pale = _mm512_and_si512(_mm512_avg_epu8(quarter_v, three_eighths_v), bounds.plain_floor);
  const __mmask64 any = _mm512_cmpge_epu8_mask(v, bounds.v_least) &
                        _mm512_cmpge_epu8_mask(chroma, _mm512_max_epu8(pale, bounds.chroma_least));
  const __m512i three_quarters = _mm512_avg_epu8(chroma, _mm512_avg_epu8(chroma, zero));
  const __mmask64 path = any & _mm512_cmpge_epu8_mask(_mm512_subs_epu8(p.g, p.b), three_quarters) &
                         _mm512_cmpge_epu8_mask(v, bounds.v_min) &
                         _mm512_cmpge_epu8_mask(chroma, three_eighths_v) & bounds.plain_path;
  if ((any & ~path) == 0) return {path, 0};
  return classify_exactly(p, test);
}

alignas(64) constexpr std::array<std::uint8_t, 64> kStepsOrder = [] {
  std::array<std::uint8_t, 64> order{};
  for (std::size_t k = 0; k < 64; ++k) {
    const std::size_t step = k / 16 % 2, green = k / 32;
    order[k] = static_cast<std::uint8_t>(64 * step + 32 * green + 2 * (k % 16));
  }
  return order;
}();

alignas(64) constexpr std::array<std::uint8_t, 64> kStraightOrder = [] {
  std::array<std::uint8_t, 64> order{};
  for (std::size_t k = 0; k < 64; ++k) order[k] = static_cast<std::uint8_t>(2 * k);
  return order;
}();

// Returns the number of marker pixels among the first width.
LINESERVO_AVX512 int classify_row(const std::int16_t* upper, const std::int16_t* lower,
                                  const BilinearTap& tap, const RedSectorTest& test,
                                  const PlainLimits& limits, int width, PackedMask::Word* path,
                                  PackedMask::Word* marker) {
  const RowWeights weights{_mm512_set1_epi16(tap.w0), _mm512_set1_epi16(tap.w1)};
  const PackOrders orders{_mm512_load_si512(kStepsOrder.data()), _mm512_load_si512(kStraightOrder.data())};
  const TestTables test_tables = tables(test, limits);
  const PlainBounds bounds = plain_bounds(test, limits);
  int marker_pixels = 0;
  for (int x = 0; x < width; x += kGroup, upper += kGroupWords, lower += kGroupWords) {
    const WordMasks masks = classify_word(blend_group(upper, lower, weights, orders), bounds, test_tables);
    const PackedMask::Word inside = ~PackedMask::Word{0} >> std::max(0, x + kGroup - width);
    *path++ = masks.path & inside;
    *marker++ = masks.marker & inside;
    marker_pixels += __builtin_popcountll(masks.marker & inside);
  }
  return marker_pixels;
}

std::int16_t* aligned(std::vector<std::int16_t>& row) {
  const auto address = reinterpret_cast<std::uintptr_t>(row.data());
  return row.data() + ((64 - address % 64) % 64) / sizeof(std::int16_t);
}

}  // namespace

bool Avx512Classifier::fits(const SegmenterOptions& options, cv::Size frame_size) {
  const int row_bytes = 3 * frame_size.width;
  if (row_bytes < kWindow) return false;
  const std::vector<BilinearTap> taps = bilinear_columns(frame_size.width, options.width_px);
  for (int x = 0; x < static_cast<int>(taps.size()); x += kStep) {
    const int first = std::min(3 * padded(taps, x).i0, row_bytes - kWindow);
    if (3 * padded(taps, x + kStep - 1).i1 + 3 - first > kWindow) return false;
  }
  return true;
}

Avx512Classifier::Avx512Classifier(const SegmenterOptions& options, const RedSectorTest& test,
                                   cv::Size frame_size)
    : test_(test),
      limits_(plain_limits(test)),
      width_(options.width_px),
      gathers_(plan_row(bilinear_columns(frame_size.width, options.width_px), 3 * frame_size.width)),
      rows_(bilinear_rows(frame_size.height, options.height_px)) {
  const std::size_t groups = (gathers_.size() + 3) / 4;
  for (auto& row : cache_) row.resize(groups * kGroupWords + 32);
}

int Avx512Classifier::classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) {
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
const std::int16_t* Avx512Classifier::resized_row(const cv::Mat& frame, int y) {
  const auto slot = static_cast<std::size_t>(y % 2);
  std::int16_t* row = aligned(cache_[slot]);
  if (cached_y_[slot] != y) {
    resize_row(frame.ptr<std::uint8_t>(y), gathers_.data(), gathers_.size(), row);
    cached_y_[slot] = y;
  }
  return row;
}

}  // namespace lineservo::features

#endif
