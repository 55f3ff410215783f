#pragma once

#include <opencv2/core/mat.hpp>

#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Image → mask of the painted line.
class Segmenter {
 public:
  virtual ~Segmenter() = default;

  /// The mask of an image (CV_8UC3 in BGR order or CV_8UC1, at least 16×16 pixels), resized to `mask_size`
  /// (16…4096 each way). Throws std::invalid_argument for any other image or size.
  virtual PackedMask segment(const cv::Mat& image, cv::Size mask_size) = 0;
};

/// Throws std::invalid_argument unless image and mask size are what Segmenter::segment takes.
void require_segmentable(const cv::Mat& image, cv::Size mask_size);

/// The image with three channels, copied only where it has one.
cv::Mat as_bgr(const cv::Mat& image);

/// The image with three channels at the size of the mask, averaged where that is smaller.
cv::Mat resized_bgr(const cv::Mat& image, cv::Size mask_size);

}  // namespace lineservo::features
