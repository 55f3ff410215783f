#pragma once

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include <iostream>
#include <opencv2/imgproc.hpp>

#include "vehicle/grabber/quiet_stderr.h"

namespace lineservo::vehicle {

/// A copy of the image in OpenCV's order.
inline cv::Mat bgr_of(const vpImage<vpRGBa>& image) {
  const cv::Mat rgba(static_cast<int>(image.getHeight()), static_cast<int>(image.getWidth()), CV_8UC4,
                     const_cast<vpRGBa*>(image.bitmap));
  cv::Mat bgr;
  cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
  return bgr;
}

/// As long as it lives, neither stderr nor std::cout says anything: ViSP's readers write to both.
class QuietStreams {
 public:
  QuietStreams() : out_(std::cout.rdbuf(nullptr)) {}
  ~QuietStreams() {
    std::cout.rdbuf(out_);
    std::cout.clear();
  }
  QuietStreams(const QuietStreams&) = delete;
  QuietStreams& operator=(const QuietStreams&) = delete;

 private:
  const QuietStderr stderr_;
  std::streambuf* out_;
};

}  // namespace lineservo::vehicle
