#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "features/line/line_detector.h"

namespace lineservo::features {

/// A way to find lines, by the name that settings and the command line use.
struct LineMethod {
  std::string_view name;
  std::string_view summary;
  bool uses_camera = false;  ///< gains from a known camera and tilt
  std::unique_ptr<LineDetector> (*make)() = nullptr;
};

/// Every method, published ones first.
std::span<const LineMethod> line_methods();

/// Throws std::invalid_argument, with the names that there are, for an unknown one.
const LineMethod& find_line_method(std::string_view name);

}  // namespace lineservo::features
