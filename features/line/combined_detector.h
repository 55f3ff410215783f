#pragma once

#include "features/line/mask_line_detector.h"
#include "features/line/skeleton_detector.h"
#include "features/line/slices_detector.h"

namespace lineservo::features {

/// `combined`: the centroids' line and the skeleton's line next to it fused (grid §IV-B2, end). The paper
/// gives no weights: equal ones. Where only one of them has a line, that line; further lines are the
/// skeleton's.
class CombinedDetector final : public MaskLineDetector {
 private:
  std::vector<ImageLine> find(const PackedMask& mask) override;

  SlicesDetector slices_;
  SkeletonDetector skeleton_;
};

}  // namespace lineservo::features
