#include "features/mask/hsv_segmenter.h"

#include "features/mask/mask_filter.h"

namespace lineservo::features {

SegmenterOptions hsv_preset(LineColor color) {
  SegmenterOptions options;
  switch (color) {
    case LineColor::yellow:
      break;
    case LineColor::red:
      options.path = options.marker[1];
      break;  // with the marker's both sides of hue 0
    case LineColor::white:
      options.path = {0, 180, 0, 60, 180, 255};
      break;
    case LineColor::black:
      options.path = {0, 180, 0, 255, 0, 70};
      break;
  }
  return options;
}

HsvSegmenter::HsvSegmenter(LineColor color)
    : bounds_(hsv_preset(color)), with_marker_(color == LineColor::red) {}

PackedMask HsvSegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  SegmenterOptions options = bounds_;
  options.width_px = mask_size.width;
  options.height_px = mask_size.height;
  PathSegmenter segmenter(options);
  const Segmentation& found = segmenter.segment(as_bgr(image));
  return with_marker_ ? found.paint : found.path;
}

PaintsSegmenter::PaintsSegmenter(const std::vector<LineColor>& colors) {
  for (const LineColor color : colors) paints_.emplace_back(color);
}

PackedMask PaintsSegmenter::segment(const cv::Mat& image, cv::Size mask_size) {
  require_segmentable(image, mask_size);
  PackedMask mask(mask_size.width, mask_size.height);
  for (HsvSegmenter& paint : paints_) mask |= paint.segment(image, mask_size);
  MaskFilter(mask.width(), mask.height()).close_5x5(mask, mask);
  return mask;
}

}  // namespace lineservo::features
