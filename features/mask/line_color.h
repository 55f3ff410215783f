#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace lineservo::features {

/// The paints that a line may have: two that differ from the floor in hue, two that differ in lightness.
enum class LineColor { yellow, red, white, black };

inline constexpr std::array kLineColors = {LineColor::yellow, LineColor::red, LineColor::white,
                                           LineColor::black};

/// Yellow and red; white and black differ from the floor in lightness.
constexpr bool has_hue(LineColor color) {
  return color == LineColor::yellow || color == LineColor::red;
}

/// "yellow" … "black".
std::string_view name(LineColor color);
/// The inverse of name(); none for any other word.
std::optional<LineColor> line_color(std::string_view name);

}  // namespace lineservo::features
