#include "features/mask/path_segmenter.h"

#include <stdexcept>
#include <string>

namespace lineservo::features {
namespace {

const SegmenterOptions& validated(const SegmenterOptions& options) {
  validate(options);
  return options;
}

void require_frame(const cv::Mat& frame) {
  if (frame.type() != CV_8UC3)
    throw std::invalid_argument("segmenter: the frame must be 8-bit BGR (CV_8UC3)");
  if (frame.cols < 16 || frame.rows < 16)
    throw std::invalid_argument("segmenter: the frame must be at least 16x16, got " +
                                std::to_string(frame.cols) + "x" + std::to_string(frame.rows));
}

}  // namespace

PathSegmenter::PathSegmenter(const SegmenterOptions& options, Processor processor)
    : options_(validated(options)),
      processor_(processor),
      filter_(options.width_px, options.height_px, processor),
      colored_(options.width_px, options.height_px),
      marker_(options.width_px, options.height_px),
      smooth_(options.width_px, options.height_px),
      result_{PackedMask(options.width_px, options.height_px),
              PackedMask(options.width_px, options.height_px),
              0,
              {}} {}

const Segmentation& PathSegmenter::segment(const cv::Mat& bgr) {
  require_frame(bgr);
  prepare_for(bgr.size());
  result_.marker_pixels = classifier_->classify(bgr, colored_, marker_);
  clean(colored_, result_.path);
  if (result_.marker_pixels == 0) {
    result_.marker_centroid_px.reset();
    result_.paint = result_.path;
  } else {
    profile_of(marker_, profile_);
    result_.marker_centroid_px = centroid(profile_);
    marker_ |= colored_;
    clean(marker_, result_.paint);
  }
  return result_;
}

void PathSegmenter::clean(const PackedMask& raw, PackedMask& cleaned) {
  filter_.median_5x5(raw, smooth_);
  filter_.close_5x5(smooth_, cleaned);
}

void PathSegmenter::prepare_for(cv::Size frame_size) {
  if (classifier_ != nullptr && frame_size == frame_size_) return;
  classifier_ = make_classifier(options_, frame_size, processor_);
  frame_size_ = frame_size;
}

}  // namespace lineservo::features
