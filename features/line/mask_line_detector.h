#pragma once

#include <vector>

#include "features/line/line_detector.h"

namespace lineservo::features {

/// What the published methods have in common: they look at the mask alone, know nothing of the camera, and
/// their lines count when enough of the mask lies along them.
class MaskLineDetector : public LineDetector {
 public:
  std::vector<DetectedLine> detect(const LineScene& scene) final;

 private:
  /// (ρ, θ) of each line, in pixels of the mask, best first. The mask holds some paint.
  virtual std::vector<ImageLine> find(const PackedMask& mask) = 0;
};

}  // namespace lineservo::features
