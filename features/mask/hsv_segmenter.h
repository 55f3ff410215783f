#pragma once

#include <vector>

#include "features/mask/line_color.h"
#include "features/mask/path_segmenter.h"
#include "features/mask/segmenter.h"

namespace lineservo::features {

/// Bounds on HSV for paint of a colour. Yellow is topology §2.5 as printed; red is its marker's.
SegmenterOptions hsv_preset(LineColor color);

/// Fixed HSV bounds, topology §2.1: resize, colour test, median, closing, by PathSegmenter.
class HsvSegmenter : public Segmenter {
 public:
  explicit HsvSegmenter(LineColor color = LineColor::yellow);
  /// The path of bounds of one's own.
  explicit HsvSegmenter(const SegmenterOptions& bounds) : bounds_(bounds) {}

  PackedMask segment(const cv::Mat& image, cv::Size mask_size) override;

 private:
  SegmenterOptions bounds_;
  bool with_marker_ = false;  ///< red is on both sides of hue 0
};

/// Fixed HSV bounds of several paints at once: what any of them takes, closed where two paints meet.
class PaintsSegmenter : public Segmenter {
 public:
  explicit PaintsSegmenter(const std::vector<LineColor>& colors);

  PackedMask segment(const cv::Mat& image, cv::Size mask_size) override;

 private:
  std::vector<HsvSegmenter> paints_;
};

}  // namespace lineservo::features
