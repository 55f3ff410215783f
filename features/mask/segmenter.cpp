#include "features/mask/segmenter.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace lineservo::features {

void require_segmentable(const cv::Mat& image, cv::Size mask_size) {
  if (image.type() != CV_8UC3 && image.type() != CV_8UC1)
    throw std::invalid_argument("segmenter: the image must have one or three 8-bit channels");
  if (image.cols < 16 || image.rows < 16)
    throw std::invalid_argument("segmenter: the image must measure at least 16×16 px");
  const auto fits = [](int side_px) { return side_px >= 16 && side_px <= 4096; };
  if (!fits(mask_size.width) || !fits(mask_size.height))
    throw std::invalid_argument("segmenter: both sides of the mask must be 16 to 4096 px");
}

cv::Mat as_bgr(const cv::Mat& image) {
  if (image.channels() == 3) return image;
  cv::Mat bgr;
  cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  return bgr;
}

cv::Mat resized_bgr(const cv::Mat& image, cv::Size mask_size) {
  if (image.size() == mask_size) return as_bgr(image);
  const bool shrinks = mask_size.width < image.cols && mask_size.height < image.rows;
  cv::Mat resized;
  cv::resize(image, resized, mask_size, 0.0, 0.0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  return as_bgr(resized);
}

}  // namespace lineservo::features
