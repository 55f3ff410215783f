#pragma once

#include "features/line/mask_line_detector.h"
#include "features/line/thinning.h"

namespace lineservo::features {

/// `skeleton`: Zhang–Suen thinning, Hough transform, mean clustering in (ρ, θ) into lines up and across the
/// image (grid §IV-B2). The paper leaves its thresholds open: votes of a fifth of the mask's short side, 100
/// at most, clusters within a twentieth of its long side and 10°.
class SkeletonDetector final : public MaskLineDetector {
 public:
  std::vector<ImageLine> find(const PackedMask& mask) override;

 private:
  Thinner thinner_;
};

}  // namespace lineservo::features
