#include "features/mask/red_sector_test.h"

#include <algorithm>

#include "features/mask/color_classes.h"

namespace lineservo::features {
namespace {

struct Curve {
  std::array<int, 256> values{};
  std::bitset<256> matters;
};

// No chroma exceeds its value.
int least_value(const HsvBounds& bounds) {
  return std::max(bounds.v_min, bounds.c_min);
}

// Smallest chroma that reaches its own bound and the saturation, for every value that is bright enough.
Curve chroma_bound(const HsvBounds& bounds) {
  Curve curve;
  for (int v = least_value(bounds); v < 256; ++v) {
    int chroma = bounds.c_min;
    while (chroma <= v && saturation(chroma, v) < bounds.s_min) ++chroma;
    curve.values[static_cast<std::size_t>(v)] = chroma;
    curve.matters.set(static_cast<std::size_t>(v));
  }
  return curve;
}

int least_chroma(const Curve& bound) {
  int least = 255;
  for (std::size_t v = 0; v < 256; ++v)
    if (bound.matters[v]) least = std::min(least, bound.values[v]);
  return least;
}

struct HueTest {
  const ColorClasses& classes;
  std::uint8_t color;

  bool accepts(int numerator, int chroma) const { return classes.of_hue(hue(numerator, chroma)) & color; }

  // Outside the sector in which red is the largest, c < n < 5c, the class is all or nothing.
  bool is_constant_outside(int chroma, bool accepted) const {
    for (int n = chroma + 1; n < 5 * chroma; ++n)
      if (accepts(n, chroma) != accepted) return false;
    return true;
  }

  // How far from n = 0 in the direction of sign the inner part reaches, if it is one piece around 0.
  std::optional<int> reach(int sign, int chroma, bool inner) const {
    int end = 0;
    while (end <= chroma && accepts(sign * end, chroma) == inner) ++end;
    for (int n = end; n <= chroma; ++n)
      if (accepts(sign * n, chroma) == inner) return std::nullopt;
    return end == 0 ? std::nullopt : std::optional(end - 1);
  }

  // The bound of the inner part for every chroma that is saturated enough, if the class has that form there.
  std::optional<Curve> bound(int sign, bool inner, int from_chroma) const {
    Curve curve;
    for (int c = from_chroma; c < 256; ++c) {
      const std::optional<int> end = reach(sign, c, inner);
      if (!end.has_value() || !is_constant_outside(c, !inner)) return std::nullopt;
      curve.values[static_cast<std::size_t>(c)] = *end;
      curve.matters.set(static_cast<std::size_t>(c));
    }
    return curve;
  }
};

std::optional<RedSectorClass> make_class(const ColorClasses& classes, std::uint8_t color,
                                         const HsvBounds& bounds) {
  if (bounds.s_max != 255 || bounds.v_max != 255) return std::nullopt;
  const HueTest test{classes, color};
  const Curve chroma = chroma_bound(bounds);
  const bool inside = test.accepts(0, 255);
  const std::optional<Curve> greener = test.bound(+1, inside, least_chroma(chroma));
  const std::optional<Curve> bluer = test.bound(-1, inside, least_chroma(chroma));
  if (!greener.has_value() || !bluer.has_value()) return std::nullopt;
  const auto chroma_curve = fit_byte_curve(chroma.values, chroma.matters);
  const auto greener_curve = fit_byte_curve(greener->values, greener->matters);
  const auto bluer_curve = fit_byte_curve(bluer->values, bluer->matters);
  if (!chroma_curve || !greener_curve || !bluer_curve) return std::nullopt;
  return RedSectorClass{static_cast<std::uint8_t>(least_value(bounds)), *chroma_curve, *greener_curve,
                        *bluer_curve, inside};
}

bool same_but_for_hue(const HsvBounds& a, const HsvBounds& b) {
  return a.s_min == b.s_min && a.s_max == b.s_max && a.v_min == b.v_min && a.v_max == b.v_max &&
         a.c_min == b.c_min;
}

}  // namespace

bool RedSectorClass::accepts(int b, int g, int r) const {
  const int v = std::max({b, g, r});
  const int chroma = v - std::min({b, g, r});
  if (v < v_min || chroma < chroma_min.at(v)) return false;
  const bool inner = r == v && g - b <= greener.at(chroma) && b - g <= bluer.at(chroma);
  return inner == inside;
}

std::optional<RedSectorTest> make_red_sector_test(const SegmenterOptions& options) {
  if (!same_but_for_hue(options.marker[0], options.marker[1])) return std::nullopt;
  const ColorClasses classes(options);
  const auto path = make_class(classes, kPath, options.path);
  const auto marker = make_class(classes, kMarker, options.marker[0]);
  if (!path || !marker) return std::nullopt;
  return RedSectorTest{*path, *marker};
}

}  // namespace lineservo::features
