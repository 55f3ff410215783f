#include "features/detect/detect_methods.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace lineservo::features {
namespace {

// The search for the colour has these already.
std::vector<ImageLine> stripes_of(const ColorChoice& paint, const MaskGeometry&) {
  return paint.seen.lines;
}

constexpr std::array kMethods = {
    DetectMethod{"stripe", "both borders of each stripe, fitted robustly", stripes_of},
};

}  // namespace

std::span<const DetectMethod> detect_methods() {
  return kMethods;
}

const DetectMethod& detect_method(std::string_view name) {
  const auto found = std::find_if(kMethods.begin(), kMethods.end(),
                                  [name](const DetectMethod& method) { return method.name == name; });
  if (found != kMethods.end()) return *found;
  std::string names;
  for (const DetectMethod& method : kMethods) names += (names.empty() ? "" : ", ") + std::string(method.name);
  throw std::invalid_argument("no method '" + std::string(name) + "'; there are: " + names);
}

}  // namespace lineservo::features
