#include "features/mask/line_color.h"

#include <algorithm>

namespace lineservo::features {

std::string_view name(LineColor color) {
  switch (color) {
    case LineColor::yellow:
      return "yellow";
    case LineColor::red:
      return "red";
    case LineColor::white:
      return "white";
    case LineColor::black:
      return "black";
  }
  return "";
}

std::optional<LineColor> line_color(std::string_view word) {
  const auto found = std::find_if(kLineColors.begin(), kLineColors.end(),
                                  [word](LineColor color) { return name(color) == word; });
  return found == kLineColors.end() ? std::nullopt : std::optional(*found);
}

}  // namespace lineservo::features
