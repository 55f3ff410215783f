#pragma once

#include <array>
#include <cstdint>

#include "features/mask/hsv.h"
#include "features/mask/segmenter_options.h"

namespace lineservo::features {

/// Which of the colours that are looked for a pixel has. Bits of a set.
enum ColorClass : std::uint8_t {
  kPath = 1,
  kMarkerLow = 2,
  kMarkerHigh = 4,
  kMarker = kMarkerLow | kMarkerHigh
};

/// The exact colour test, for any bounds: one table a channel, and one of the chroma, of the classes that
/// its value admits; their intersection is cv::cvtColor followed by cv::inRange, and a bound on max − min.
class ColorClasses {
 public:
  explicit ColorClasses(const SegmenterOptions& options);

  std::uint8_t of_hue(int h) const { return hue_[static_cast<std::size_t>(h)]; }
  std::uint8_t of_saturation(int s) const { return saturation_[static_cast<std::size_t>(s)]; }
  std::uint8_t of_value(int v) const { return value_[static_cast<std::size_t>(v)]; }

  std::uint8_t of_chroma(int c) const { return chroma_[static_cast<std::size_t>(c)]; }

  std::uint8_t of(int b, int g, int r) const {
    const int v = std::max(std::max(b, g), r);
    const int chroma = v - std::min(std::min(b, g), r);
    const int candidates = of_value(v) & of_saturation(saturation(chroma, v)) & of_chroma(chroma);
    if (candidates == 0) return 0;  // bare floor, as most pixels are
    return static_cast<std::uint8_t>(candidates & of_hue(hue(hue_numerator(b, g, r, v, chroma), chroma)));
  }

 private:
  void admit(const HsvBounds& bounds, ColorClass color);

  std::array<std::uint8_t, 256> hue_{}, saturation_{}, value_{}, chroma_{};
};

}  // namespace lineservo::features
