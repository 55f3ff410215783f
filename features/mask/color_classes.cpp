#include "features/mask/color_classes.h"

namespace lineservo::features {
namespace {

void admit_interval(std::array<std::uint8_t, 256>& table, int low, int high, ColorClass color) {
  for (int i = low; i <= high; ++i) table[static_cast<std::size_t>(i)] |= color;
}

}  // namespace

ColorClasses::ColorClasses(const SegmenterOptions& options) {
  validate(options);
  admit(options.path, kPath);
  admit(options.marker[0], kMarkerLow);
  admit(options.marker[1], kMarkerHigh);
}

void ColorClasses::admit(const HsvBounds& bounds, ColorClass color) {
  admit_interval(hue_, bounds.h_min, bounds.h_max, color);
  admit_interval(saturation_, bounds.s_min, bounds.s_max, color);
  admit_interval(value_, bounds.v_min, bounds.v_max, color);
  admit_interval(chroma_, bounds.c_min, 255, color);
}

}  // namespace lineservo::features
