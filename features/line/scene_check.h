#pragma once

#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <stdexcept>

namespace lineservo::features {

/// Throws std::invalid_argument unless the image is 8-bit grey or BGR and not empty.
inline void require_image(const cv::Mat& image) {
  if (image.empty() || (image.type() != CV_8UC1 && image.type() != CV_8UC3))
    throw std::invalid_argument("line detection: the image must be 8-bit grey or BGR, and not empty");
}

/// Smaller images hold no line that could be told from noise.
inline bool is_large_enough(const cv::Mat& image) {
  return std::min(image.cols, image.rows) >= 16;
}

}  // namespace lineservo::features
