#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "features/mask/packed_mask.h"
#include "features/mask/processor.h"
#include "features/mask/segmenter_options.h"

namespace lineservo::features {

/// Resizes a frame and tests the colour of every pixel of the result in one pass: what cv::resize, cvtColor
/// and inRange do one after the other, bit for bit. Keeps its scratch memory between frames.
class FrameClassifier {
 public:
  virtual ~FrameClassifier() = default;

  /// Writes the path mask of a CV_8UC3 BGR frame of the size that the classifier was made for into `path`
  /// (of the resized size). Returns the number of marker pixels.
  virtual int classify(const cv::Mat& frame, PackedMask& path, PackedMask& marker) = 0;
};

/// A classifier for frames of the given size, at least 16×16.
std::unique_ptr<FrameClassifier> make_classifier(const SegmenterOptions& options, cv::Size frame_size,
                                                 Processor processor);

}  // namespace lineservo::features
