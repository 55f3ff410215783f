#pragma once

#include <optional>

#include "features/mask/byte_curve.h"
#include "features/mask/segmenter_options.h"

namespace lineservo::features {

/// The colour test of one class in differences of bytes. With v = max(b, g, r), chroma c = v − min(b, g, r):
///   v ≥ v_min  and  c ≥ chroma_min(v)  and  hue,
/// where hue depends on whether the colour is within `greener` and `bluer` of pure red:
///   inner = (r = v  and  g − b ≤ greener(c)  and  b − g ≤ bluer(c)),   hue = inner or not inner.
/// Exact, because every bound comes from OpenCV's rounded arithmetic and not from the ideal line.
struct RedSectorClass {
  std::uint8_t v_min = 0;
  ByteCurve chroma_min;
  ByteCurve greener, bluer;
  bool inside = true;  ///< the class is the inner part, or all but the inner part

  bool accepts(int b, int g, int r) const;
};

/// The tests of the path and of the start marker.
struct RedSectorTest {
  RedSectorClass path, marker;
};

/// The two tests, or nothing when the bounds cannot be written so: upper bounds of S and V below 255, a hue
/// bound outside the sector in which red is the largest, or marker ranges that differ in S or V.
std::optional<RedSectorTest> make_red_sector_test(const SegmenterOptions& options);

}  // namespace lineservo::features
