#pragma once

#include <algorithm>
#include <cstdint>

#include "features/mask/red_sector_test.h"

namespace lineservo::features::vector_test {

/// What decides on most pixels before the exact test.
struct PlainLimits {
  int v_least = 0, chroma_least = 0;  ///< of a pixel of either class
  bool pale_is_floor = false;         ///< c < 5/16 v makes a pixel neither
  bool plain_green_is_path = false;  ///< c ≥ 3/8 v and g − b ≥ 3/4 c make such a bright pixel path alone
};

}  // namespace lineservo::features::vector_test

#if defined(__x86_64__)

#include <immintrin.h>

// The colour test of 32 pixels, for the classifiers that are written in vector instructions. Only functions
// marked so may use them; nothing else of such a file, and no inline function of the standard library, is
// compiled for them.
#define LINESERVO_AVX2 __attribute__((target("avx2,popcnt")))
#define LINESERVO_AVX2_INLINE __attribute__((target("avx2,popcnt"), always_inline)) inline

namespace lineservo::features::vector_test {

struct CurveTables {
  __m256i high, low, bits_lower, bits_upper;
};

struct ClassTables {
  __m256i v_min;
  CurveTables chroma_min, greener, bluer;
  __m256i outside;  // all ones when the class is all but the inner part
};

LINESERVO_AVX2_INLINE __m256i twice(const std::array<std::uint8_t, 16>& table) {
  return _mm256_broadcastsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(table.data())));
}

LINESERVO_AVX2_INLINE CurveTables tables(const ByteCurve& curve) {
  return {twice(curve.high), twice(curve.low), twice(curve.bits_lower), twice(curve.bits_upper)};
}

LINESERVO_AVX2_INLINE ClassTables tables(const RedSectorClass& color) {
  return {_mm256_set1_epi8(static_cast<char>(color.v_min)), tables(color.chroma_min), tables(color.greener),
          tables(color.bluer), _mm256_set1_epi8(color.inside ? 0 : -1)};
}

// The two half-bytes of an argument, and the one bit that its upper half selects in a byte.
struct CurveArgument {
  __m256i whole, high, low, bit;
};

LINESERVO_AVX2_INLINE CurveArgument split(__m256i x) {
  const __m256i nibble = _mm256_set1_epi8(15);
  const __m256i powers = _mm256_setr_epi8(1, 2, 4, 8, 16, 32, 64, -128, 1, 2, 4, 8, 16, 32, 64, -128,  //
                                          1, 2, 4, 8, 16, 32, 64, -128, 1, 2, 4, 8, 16, 32, 64, -128);
  const __m256i high = _mm256_and_si256(_mm256_srli_epi16(x, 4), nibble);
  return {x, high, _mm256_and_si256(x, nibble), _mm256_shuffle_epi8(powers, high)};
}

LINESERVO_AVX2_INLINE __m256i evaluate(const CurveTables& curve, const CurveArgument& x) {
  const __m256i sum =
      _mm256_add_epi8(_mm256_shuffle_epi8(curve.high, x.high), _mm256_shuffle_epi8(curve.low, x.low));
  const __m256i bits = _mm256_blendv_epi8(_mm256_shuffle_epi8(curve.bits_lower, x.low),
                                          _mm256_shuffle_epi8(curve.bits_upper, x.low), x.whole);
  return _mm256_add_epi8(sum, _mm256_cmpeq_epi8(_mm256_and_si256(bits, x.bit), x.bit));
}

LINESERVO_AVX2_INLINE __m256i at_least(__m256i a, __m256i b) {
  return _mm256_cmpeq_epi8(_mm256_max_epu8(a, b), a);
}

struct Pixels {
  __m256i value, is_red, greener, bluer;
  CurveArgument chroma;
};

LINESERVO_AVX2_INLINE __m256i bright_and_saturated(const ClassTables& color, const CurveArgument& value,
                                                   __m256i chroma) {
  return _mm256_and_si256(at_least(value.whole, color.v_min),
                          at_least(chroma, evaluate(color.chroma_min, value)));
}

LINESERVO_AVX2_INLINE __m256i has_hue(const ClassTables& color, const Pixels& p) {
  const __m256i inner = _mm256_and_si256(at_least(evaluate(color.greener, p.chroma), p.greener),
                                         at_least(evaluate(color.bluer, p.chroma), p.bluer));
  return _mm256_xor_si256(_mm256_and_si256(inner, p.is_red), color.outside);
}

LINESERVO_AVX2_INLINE std::uint32_t bits(__m256i mask) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(mask));
}

struct TestTables {
  ClassTables path, marker;
  __m256i v_least, chroma_least;  // of a pixel of either class
  __m256i plain_floor;            // all ones when pale_is_floor() holds
  __m256i plain_path;             // all ones when pixels that are plainly path may be told by plain_green()
};

// As _mm256_avg_epu8 has it, and what plain_test() makes of it.
inline int average(int a, int b) {
  return (a + b + 1) / 2;
}

inline int half(int x) {
  return average(x, 0);
}

inline int three_quarters(int x) {
  return average(x, half(x));
}

inline int three_eighths(int x) {
  return average(half(half(x)), half(x));
}

inline int five_sixteenths(int x) {
  return average(half(half(x)), three_eighths(x));
}

// Whether no pixel with c < 5/16 v is of either class.
inline bool pale_is_floor(const RedSectorTest& test) {
  for (int v = 0; v < 256; ++v)
    for (const RedSectorClass* color : {&test.path, &test.marker})
      if (v >= color->v_min && color->chroma_min.at(v) < five_sixteenths(v)) return false;
  return true;
}

// Pure green-reds: whether c ≥ max(3/8 v, least) and g − b ≥ 3/4 c make any bright pixel path and none
// marker.
inline bool plain_green_is_path(const RedSectorTest& test, int least) {
  if (test.path.inside || !test.marker.inside) return false;
  for (int v = test.path.v_min; v < 256; ++v)
    if (test.path.chroma_min.at(v) > std::max(three_eighths(v), least)) return false;
  for (int c = std::max(three_eighths(test.path.v_min), least); c < 256; ++c)
    if (c == 0 || std::max(test.path.greener.at(c), test.marker.greener.at(c)) >= three_quarters(c))
      return false;
  return true;
}

inline int least_chroma(const RedSectorClass& color) {
  int least = 255;
  for (int v = color.v_min; v < 256; ++v) least = std::min(least, color.chroma_min.at(v));
  return least;
}

inline PlainLimits plain_limits(const RedSectorTest& test) {
  const int least = std::min(least_chroma(test.path), least_chroma(test.marker));
  return {std::min(test.path.v_min, test.marker.v_min), least, pale_is_floor(test),
          plain_green_is_path(test, least)};
}

LINESERVO_AVX2_INLINE TestTables tables(const RedSectorTest& test, const PlainLimits& limits) {
  return {tables(test.path),
          tables(test.marker),
          _mm256_set1_epi8(static_cast<char>(limits.v_least)),
          _mm256_set1_epi8(static_cast<char>(limits.chroma_least)),
          _mm256_set1_epi8(limits.pale_is_floor ? -1 : 0),
          _mm256_set1_epi8(limits.plain_green_is_path ? -1 : 0)};
}

// Pixels that may be of either class, and those of them that plainly are path.
struct PlainTest {
  __m256i any, path;
};

// Without the tables. Floor is dark or pale; yellow paint is bright, saturated and far from red.
LINESERVO_AVX2_INLINE PlainTest plain_test(__m256i v, __m256i chroma, __m256i greener,
                                           const TestTables& test) {
  const __m256i zero = _mm256_setzero_si256();
  const __m256i half_v = _mm256_avg_epu8(v, zero), quarter_v = _mm256_avg_epu8(half_v, zero);
  const __m256i three_eighths_v = _mm256_avg_epu8(quarter_v, half_v);
  const __m256i five_sixteenths_v = _mm256_avg_epu8(quarter_v, three_eighths_v);
  const __m256i least =
      _mm256_max_epu8(test.chroma_least, _mm256_and_si256(five_sixteenths_v, test.plain_floor));
  const __m256i any = _mm256_and_si256(at_least(v, test.v_least), at_least(chroma, least));
  const __m256i far = at_least(greener, _mm256_avg_epu8(chroma, _mm256_avg_epu8(chroma, zero)));
  const __m256i bright = _mm256_and_si256(at_least(v, test.path.v_min), at_least(chroma, three_eighths_v));
  return {any, _mm256_and_si256(_mm256_and_si256(bright, far), _mm256_and_si256(any, test.plain_path))};
}

struct GroupMasks {
  std::uint32_t path = 0, marker = 0;
};

LINESERVO_AVX2_INLINE GroupMasks classify_group(__m256i b, __m256i g, __m256i r, const TestTables& test) {
  const __m256i v = _mm256_max_epu8(_mm256_max_epu8(b, g), r);
  const __m256i chroma = _mm256_sub_epi8(v, _mm256_min_epu8(_mm256_min_epu8(b, g), r));
  const __m256i greener = _mm256_subs_epu8(g, b);
  const PlainTest plain = plain_test(v, chroma, greener, test);
  // Nearly all groups; one branch for them, because paint and floor alternate too wildly to be predicted.
  if (_mm256_testc_si256(plain.path, plain.any)) return {bits(plain.path), 0};
  const CurveArgument value = split(v);
  const Pixels p{v, _mm256_cmpeq_epi8(v, r), greener, _mm256_subs_epu8(b, g), split(chroma)};
  const __m256i path =
      _mm256_and_si256(bright_and_saturated(test.path, value, chroma), has_hue(test.path, p));
  const __m256i marker_hue = has_hue(test.marker, p);
  if (_mm256_testz_si256(marker_hue, marker_hue)) return {bits(path), 0};
  return {bits(path), bits(_mm256_and_si256(bright_and_saturated(test.marker, value, chroma), marker_hue))};
}

}  // namespace lineservo::features::vector_test

#endif
