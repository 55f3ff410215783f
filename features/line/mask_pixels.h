#pragma once

#include <bit>
#include <opencv2/core/mat.hpp>

#include "features/mask/packed_mask.h"

namespace lineservo::features {

/// Calls each(x, y) for every foreground pixel, row by row.
template <typename Each>
void for_each_pixel(const PackedMask& mask, Each&& each) {
  for (int y = 0; y < mask.height(); ++y) {
    const auto row = mask.row(y);
    for (std::size_t word = 0; word < row.size(); ++word)
      for (PackedMask::Word bits = row[word]; bits != 0; bits &= bits - 1)
        each(static_cast<int>(word) * PackedMask::kWordBits + std::countr_zero(bits), y);
  }
}

/// CV_8UC1 with 255 for foreground; quick where the mask is sparse.
inline cv::Mat unpacked(const PackedMask& mask) {
  cv::Mat image = cv::Mat::zeros(mask.height(), mask.width(), CV_8UC1);
  for_each_pixel(mask, [&image](int x, int y) { image.ptr(y)[x] = 255; });
  return image;
}

}  // namespace lineservo::features
