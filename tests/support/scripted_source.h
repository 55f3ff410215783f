#pragma once

#include <string>
#include <utility>
#include <vector>

#include "vehicle/grabber/frame_source.h"

namespace lineservo::support {

/// A double of a camera: gives the images that it was given, 10 a second, then ends, or breaks off with a
/// GrabberError.
class ScriptedSource : public vehicle::FrameSource {
 public:
  explicit ScriptedSource(std::vector<cv::Mat> images, std::string breaks_off = "")
      : images_(std::move(images)), breaks_off_(std::move(breaks_off)) {}

  vehicle::SourceFormat format() const override { return {images_.at(0).cols, images_.at(0).rows, 10.0}; }
  std::optional<vehicle::SourceFrame> next() override {
    if (index_ == images_.size() && !breaks_off_.empty()) throw vehicle::GrabberError(breaks_off_);
    if (index_ == images_.size()) return std::nullopt;
    vehicle::SourceFrame frame;
    frame.index = static_cast<std::int64_t>(index_);
    frame.stamp = vehicle::from_seconds(0.1 * static_cast<double>(index_));
    frame.bgr = images_[index_++].clone();
    return frame;
  }

 private:
  std::vector<cv::Mat> images_;
  std::string breaks_off_;
  std::size_t index_ = 0;
};

}  // namespace lineservo::support
