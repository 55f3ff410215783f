#pragma once

#include "features/line/mask_line_detector.h"

namespace lineservo::features {

/// `slices`: the mask is cut into slices, more of them where less of it is painted; each contour of a slice
/// gives its centroid, RANSAC the line (grid §IV-B1, Alg. 1). The paper cuts across a line that runs up the
/// image; here the slices are columns where the paint runs across it. One line.
class SlicesDetector final : public MaskLineDetector {
 public:
  /// How many slices a mask gets: 2 / (painted share), within 6…40.
  static int slice_count(double painted_share);

  std::vector<ImageLine> find(const PackedMask& mask) override;
};

}  // namespace lineservo::features
