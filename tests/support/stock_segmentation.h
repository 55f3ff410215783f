#pragma once

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "features/mask/segmenter_options.h"

namespace lineservo::support {

/// topology §2.1 in plain OpenCV calls, step by step: what the packed pipeline must equal and is timed
/// against.
class StockSegmentation {
 public:
  explicit StockSegmentation(const features::SegmenterOptions& options = {}) : options_(options) {}

  void resize(const cv::Mat& bgr) {
    cv::resize(bgr, resized, {options_.width_px, options_.height_px}, 0.0, 0.0, cv::INTER_LINEAR);
  }
  void classify() {
    cv::cvtColor(resized, hsv_, cv::COLOR_BGR2HSV);
    if (looks_at_chroma()) measure_chroma();
    in_range(options_.path, colored);
    in_range(options_.marker[0], marker);
    in_range(options_.marker[1], marker_high_);
    cv::bitwise_or(marker, marker_high_, marker);
    marker_pixels = cv::countNonZero(marker);
  }
  void median() { cv::medianBlur(colored, smooth, 5); }
  void close() { cv::morphologyEx(smooth, path, cv::MORPH_CLOSE, kernel_); }

  void segment(const cv::Mat& bgr) {
    resize(bgr);
    classify();
    median();
    close();
  }

  cv::Mat resized, colored, marker, smooth, path;
  int marker_pixels = 0;

 private:
  bool looks_at_chroma() const {
    return std::max({options_.path.c_min, options_.marker[0].c_min, options_.marker[1].c_min}) > 0;
  }
  // The largest channel less the smallest.
  void measure_chroma() {
    cv::split(resized, channels_);
    cv::max(channels_[0], channels_[1], largest_);
    cv::max(largest_, channels_[2], largest_);
    cv::min(channels_[0], channels_[1], chroma_);
    cv::min(chroma_, channels_[2], chroma_);
    cv::subtract(largest_, chroma_, chroma_);
  }
  void in_range(const features::HsvBounds& bounds, cv::Mat& mask) const {
    cv::inRange(hsv_, cv::Scalar(bounds.h_min, bounds.s_min, bounds.v_min),
                cv::Scalar(bounds.h_max, bounds.s_max, bounds.v_max), mask);
    if (bounds.c_min > 0) mask &= chroma_ >= bounds.c_min;
  }

  features::SegmenterOptions options_;
  cv::Mat hsv_, marker_high_, largest_, chroma_;
  std::vector<cv::Mat> channels_;
  cv::Mat kernel_ = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
};

/// The stock way to densities: one count for each of the 80 bins.
inline int stock_densities(const cv::Mat& mask) {
  int sum = 0;
  for (int k = 0; k < 40; ++k)
    sum += cv::countNonZero(mask.colRange(10 * k, 10 * k + 10)) +
           cv::countNonZero(mask.rowRange(10 * k, 10 * k + 10));
  return sum;
}

}  // namespace lineservo::support
