#include "features/mask/segmenter_options.h"

#include <stdexcept>
#include <string>

namespace lineservo::features {
namespace {

class Faults {
 public:
  void require(bool holds, const std::string& fault) {
    if (!holds) list_ += (list_.empty() ? "" : "; ") + fault;
  }
  void require_interval(const std::string& name, int low, int high, int limit) {
    require(0 <= low && low <= high && high <= limit,
            name + " must hold 0 <= min <= max <= " + std::to_string(limit) + ", got " + std::to_string(low) +
                " to " + std::to_string(high));
  }
  void require_bounds(const std::string& name, const HsvBounds& bounds) {
    require_interval(name + " hue", bounds.h_min, bounds.h_max, 180);
    require_interval(name + " saturation", bounds.s_min, bounds.s_max, 255);
    require_interval(name + " value", bounds.v_min, bounds.v_max, 255);
    require_interval(name + " chroma", bounds.c_min, 255, 255);
  }
  const std::string& list() const { return list_; }

 private:
  std::string list_;
};

}  // namespace

SegmenterOptions any_light_ranges() {
  constexpr int kChroma = 28;  // floor: 4 σ of noise of 7 levels; yellow in 0.4 of the light has 92
  SegmenterOptions options;
  options.path = {18, 175, 0, 255, 0, 255, kChroma};
  options.marker = {HsvBounds{0, 10, 0, 255, 0, 255, kChroma}, HsvBounds{170, 180, 0, 255, 0, 255, kChroma}};
  return options;
}

void validate(const SegmenterOptions& options) {
  Faults faults;
  faults.require(options.width_px >= 16 && options.width_px <= 4096, "width must be 16 to 4096 px");
  faults.require(options.height_px >= 16 && options.height_px <= 4096, "height must be 16 to 4096 px");
  faults.require_bounds("path", options.path);
  for (const HsvBounds& range : options.marker) faults.require_bounds("marker", range);
  if (!faults.list().empty()) throw std::invalid_argument("segmenter: " + faults.list());
}

}  // namespace lineservo::features
