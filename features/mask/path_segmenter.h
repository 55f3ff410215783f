#pragma once

#include <memory>
#include <optional>

#include "features/mask/frame_classifier.h"
#include "features/mask/mask_filter.h"
#include "features/mask/mask_profile.h"
#include "features/mask/packed_mask.h"
#include "features/mask/segmenter_options.h"

namespace lineservo::features {

/// What the segmentation finds in one frame.
struct Segmentation {
  PackedMask path;        ///< after median and closing
  PackedMask paint;       ///< the same for path and marker together: the stripes run on under a marker
  int marker_pixels = 0;  ///< in the resized frame
  std::optional<PixelPoint> marker_centroid_px;  ///< of the marker, in the resized frame
};

/// Frame → path mask and marker pixels, topology §2.1 with the parameters of §2.5: resize, colour test,
/// median 5×5, closing 5×5. Bit for bit what OpenCV's resize, cvtColor, inRange, medianBlur and morphologyEx
/// give one after the other. Holds its scratch memory: after the first frame of a size nothing is allocated.
class PathSegmenter {
 public:
  /// Throws std::invalid_argument when the options are not valid.
  explicit PathSegmenter(const SegmenterOptions& options = {}, Processor processor = best_processor());

  /// The result stays valid until the next call. Throws std::invalid_argument unless the frame is CV_8UC3 of
  /// at least 16×16.
  const Segmentation& segment(const cv::Mat& bgr);

  const SegmenterOptions& options() const { return options_; }

 private:
  void prepare_for(cv::Size frame_size);
  /// topology §2.1: median, then closing.
  void clean(const PackedMask& raw, PackedMask& cleaned);

  SegmenterOptions options_;
  Processor processor_;
  cv::Size frame_size_;
  std::unique_ptr<FrameClassifier> classifier_;
  MaskFilter filter_;
  PackedMask colored_, marker_, smooth_;
  MaskProfile profile_;
  Segmentation result_;
};

}  // namespace lineservo::features
