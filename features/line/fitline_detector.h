#pragma once

#include "features/line/mask_line_detector.h"

namespace lineservo::features {

/// `fitline`: M-estimator least squares over the points of the line (lfpf §3.3.3, Alg. 3), with Huber's
/// weights as cv::fitLine has them. The paper takes every point, which costs seconds on a large mask: here a
/// square lattice of at most kPoints of them, evenly over the mask. One line.
class FitlineDetector final : public MaskLineDetector {
 public:
  static constexpr int kPoints = 500;

 private:
  std::vector<ImageLine> find(const PackedMask& mask) override;
};

}  // namespace lineservo::features
