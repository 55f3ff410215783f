#pragma once

#include "features/line/mask_line_detector.h"

namespace lineservo::features {

/// `centroid`: the line through the mask's centroid along its principal axis, from the moments up to the
/// second order (topology eq. 2 has the centroid alone). One line.
class CentroidDetector final : public MaskLineDetector {
 private:
  std::vector<ImageLine> find(const PackedMask& mask) override;
};

}  // namespace lineservo::features
