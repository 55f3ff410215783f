#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/detect/auto_segmenter.h"

namespace lineservo::features {

/// A way from what was segmented to lines, the best to follow first.
struct DetectMethod {
  std::string_view name;
  std::string_view summary;
  std::vector<ImageLine> (*find)(const ColorChoice& paint, const MaskGeometry& geometry);
};

/// Every method that there is; the first is the default.
std::span<const DetectMethod> detect_methods();

/// Throws std::invalid_argument, with the names that there are, for any other name.
const DetectMethod& detect_method(std::string_view name);

}  // namespace lineservo::features
