#include "features/perception.h"

#include <algorithm>
#include <stdexcept>

#include "features/junction/fpd.h"
#include "features/line/line_methods.h"
#include "features/line/stripe_stand_in.h"
#include "features/point/disc.h"

namespace lineservo::features {
namespace {

std::unique_ptr<LineDetector> detector_of(const std::string& line_method) {
  const LineMethod& method = find_line_method(line_method);
  return line_method == "stripe" ? nullptr : method.make();
}

SeenByAll seen_by_all(const FrameFeatures& features, const StripeFeatures& stripes) {
  SeenByAll seen{features.centroid_px, std::nullopt};
  if (!stripes.lines.empty()) seen.stripe_width = stripes.lines.front().width;
  return seen;
}

}  // namespace

Perception::Perception(const CameraModel& camera, const PerceptionOptions& options)
    : options_(options),
      frame_size_(camera.width_px(), camera.height_px()),
      segmenter_(ranges_of(options.path, options.segmenter)),
      geometry_(camera, options.segmenter.width_px, options.segmenter.height_px),
      stripes_(geometry_, options.stripe),
      line_detector_(detector_of(options.line_method)),
      pose_{camera, LevelView()},
      law_features_(camera, geometry_, options.needs,
                    {ranges_of(options.path, options.segmenter), options.path, options.target}),
      filter_(options.junction_window),
      tracker_(options.tracker),
      path_segmenter_(is_fast(options.path) ? nullptr : make_segmenter(options.path)) {}

FrameFeatures Perception::observe(const cv::Mat& bgr, const FrameContext& context) {
  if (bgr.size() != frame_size_) {
    throw std::invalid_argument("the frame is " + std::to_string(bgr.cols) + "×" + std::to_string(bgr.rows) +
                                " px, the camera " + std::to_string(frame_size_.width) + "×" +
                                std::to_string(frame_size_.height));
  }
  segmentation_ = &segmenter_.segment(bgr);
  if (path_segmenter_) replace_path(bgr);
  marker_px_ = find_marker(context.height_m);
  profile_of(segmentation_->path, profile_);
  const StripeFeatures& stripes = stripes_.observe(segmentation_->paint.view(), context.view, prior(context));

  FrameFeatures features;
  features.lines = line_detector_ ? with_stripes(detect_lines(bgr, context.view), stripes.lines,
                                                 stripes.junction ? LinesMeet::yes : LinesMeet::no)
                                  : stripes.lines;
  if (options_.line_filter == LineFilter::kalman) track(features.lines, context);
  features.junction = stripes.junction;
  features.line_end = stripes.line_end;
  features.centroid_px = centroid(profile_);
  features.marker_pixels = segmentation_->marker_pixels;
  if (marker_px_) features.start_marker = context.view.level(geometry_.normalize(*marker_px_));
  features.foreground_ratio = foreground_ratio(profile_);
  features.law = law_features_.extract(bgr, *segmentation_, seen_by_all(features, stripes), context);
  bool line_ends_ahead = false;
  const JunctionCode raw = read_code(stripes, line_ends_ahead);
  features.code = filter_.update(raw, line_ends_ahead);
  return features;
}

std::optional<PixelPoint> Perception::find_marker(double height_m) const {
  if (options_.marker == MarkerMethod::eroded)
    return end_disc_as_published(segmentation_->path, pose_.camera, height_m);
  return segmentation_->marker_pixels > kStartMarkerLimit_px ? segmentation_->marker_centroid_px
                                                             : std::nullopt;
}

void Perception::replace_path(const cv::Mat& bgr) {
  const cv::Size size(options_.segmenter.width_px, options_.segmenter.height_px);
  replaced_ = *segmentation_;
  replaced_.path = path_segmenter_->segment(bgr, size);
  const bool only_path = replaced_.marker_pixels == 0 || options_.marker == MarkerMethod::eroded;
  if (only_path) {
    replaced_.paint = replaced_.path;
  } else {
    replaced_.paint |= replaced_.path;
  }
  segmentation_ = &replaced_;
}

std::optional<StripePrior> Perception::prior(const FrameContext& context) const {
  if (options_.line_filter != LineFilter::kalman) return std::nullopt;
  const std::optional<LineFeature> line = tracker_.expected(context.height_m);
  if (!line) return std::nullopt;
  return StripePrior{line->rho, line->theta_rad, line->width};
}

// The tracked line takes the first place; a seen one replaces its raw form.
void Perception::track(std::vector<LineFeature>& lines, const FrameContext& context) {
  const std::optional<TrackedLine> tracked = tracker_.update(context.since_last_s, context.height_m, lines);
  if (!tracked) return;
  const auto raw = std::find_if(lines.begin(), lines.end(), [&tracked](const LineFeature& line) {
    return line.begin.x == tracked->line.begin.x && line.end.x == tracked->line.end.x;
  });
  if (!tracked->predicted && raw != lines.end()) lines.erase(raw);
  lines.insert(lines.begin(), tracked->line);
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
    const DensityReading reading =
        read_densities(pixel_densities(profile_), marker_px_ ? kStartMarkerLimit_px + 1 : 0);
    line_ends_ahead = reading.line_ends_ahead;
    return reading.code;
  }
  line_ends_ahead = stripes.line_ends_ahead;
  return marker_px_ ? JunctionCode::start : stripes.raw;
}

}  // namespace lineservo::features
