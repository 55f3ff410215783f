#include "features/mask/difference_segmenter.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace lineservo::features {

DifferenceSegmenter::DifferenceSegmenter(const DifferenceOptions& options) : options_(options) {
  if (!(options.green_divisor >= 1.0) || !(options.blue_divisor >= 1.0))
    throw std::invalid_argument("difference segmenter: the divisors must be at least 1");
  if (!(options.threshold >= 0.0 && options.threshold <= 255.0))
    throw std::invalid_argument("difference segmenter: the threshold must be 0 to 255");
  if (options.erosion_px < 1 || options.erosion_px > 64)
    throw std::invalid_argument("difference segmenter: the erosion must be 1 to 64 px");
}

PackedMask DifferenceSegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  const cv::Mat bgr = resized_bgr(image, mask_size);
  cv::Mat binary(bgr.size(), CV_8UC1);
  for (int y = 0; y < bgr.rows; ++y) {
    const auto* in = bgr.ptr<cv::Vec3b>(y);
    auto* out = binary.ptr<std::uint8_t>(y);
    for (int x = 0; x < bgr.cols; ++x) {
      const double F = in[x][2] - in[x][1] / options_.green_divisor - in[x][0] / options_.blue_divisor;
      out[x] = F >= options_.threshold ? 255 : 0;
    }
  }
  const cv::Size square(options_.erosion_px, options_.erosion_px);
  cv::erode(binary, binary, cv::getStructuringElement(cv::MORPH_RECT, square));
  return PackedMask::from_mat(binary);
}

}  // namespace lineservo::features
