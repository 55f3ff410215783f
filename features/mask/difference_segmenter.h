#pragma once

#include "features/mask/segmenter.h"

namespace lineservo::features {

/// vtp §3.1 with the parameters of its published code.
struct DifferenceOptions {
  double green_divisor = 2.0;  ///< GG, at least 1
  double blue_divisor = 2.0;   ///< GB, at least 1
  double threshold = 100.0;    ///< K_T, levels
  int erosion_px = 8;          ///< side of the square, 1 for none
};

/// Red paint by channel difference: F = R − G / GG − B / GB (vtp eq. 1), thresholded, then eroded by a
/// square.
class DifferenceSegmenter : public Segmenter {
 public:
  /// Throws std::invalid_argument for options out of bounds.
  explicit DifferenceSegmenter(const DifferenceOptions& options = {});

  PackedMask segment(const cv::Mat& image, cv::Size mask_size) override;

 private:
  DifferenceOptions options_;
};

}  // namespace lineservo::features
