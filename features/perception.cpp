#include "features/perception.h"

#include <stdexcept>

#include "features/junction/fpd.h"
#include "features/line/line_methods.h"

namespace lineservo::features {
namespace {

std::unique_ptr<LineDetector> detector_of(const std::string& line_method) {
  const LineMethod& method = find_line_method(line_method);
  return line_method == "stripe" ? nullptr : method.make();
}

}  // namespace

Perception::Perception(const CameraModel& camera, const PerceptionOptions& options)
    : options_(options),
      frame_size_(camera.width_px(), camera.height_px()),
      segmenter_(options.segmenter),
      geometry_(camera, options.segmenter.width_px, options.segmenter.height_px),
      stripes_(geometry_, options.stripe),
      line_detector_(detector_of(options.line_method)),
      pose_{camera, LevelView()},
      filter_(options.junction_window) {}

FrameFeatures Perception::observe(const cv::Mat& bgr, const LevelView& view) {
  if (bgr.size() != frame_size_) {
    throw std::invalid_argument("the frame is " + std::to_string(bgr.cols) + "×" + std::to_string(bgr.rows) +
                                " px, the camera " + std::to_string(frame_size_.width) + "×" +
                                std::to_string(frame_size_.height));
  }
  segmentation_ = &segmenter_.segment(bgr);
  profile_of(segmentation_->path, profile_);
  const StripeFeatures& stripes = stripes_.observe(segmentation_->paint.view(), view);

  FrameFeatures features;
  features.lines = line_detector_ ? detect_lines(bgr, view) : stripes.lines;
  features.junction = stripes.junction;
  features.centroid_px = centroid(profile_);
  features.marker_pixels = segmentation_->marker_pixels;
  if (segmentation_->marker_pixels > kStartMarkerLimit_px)
    features.start_marker = view.level(geometry_.normalize(*segmentation_->marker_centroid_px));
  features.foreground_ratio = foreground_ratio(profile_);
  bool line_ends_ahead = false;
  const JunctionCode raw = read_code(stripes, line_ends_ahead);
  features.code = filter_.update(raw, line_ends_ahead);
  return features;
}

std::vector<LineFeature> Perception::detect_lines(const cv::Mat& bgr, const LevelView& view) {
  pose_.view = view;
  std::vector<LineFeature> lines;
  for (const DetectedLine& line : line_detector_->detect({bgr, segmentation_->paint, &pose_}))
    lines.push_back(*line.level);
  return lines;
}

JunctionCode Perception::read_code(const StripeFeatures& stripes, bool& line_ends_ahead) const {
  if (options_.junction_method == JunctionMethod::fpd) {
    const DensityReading reading = read_densities(pixel_densities(profile_), segmentation_->marker_pixels);
    line_ends_ahead = reading.line_ends_ahead;
    return reading.code;
  }
  line_ends_ahead = stripes.line_ends_ahead;
  return segmentation_->marker_pixels > kStartMarkerLimit_px ? JunctionCode::start : stripes.raw;
}

}  // namespace lineservo::features
