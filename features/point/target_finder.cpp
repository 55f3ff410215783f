#include "features/point/target_finder.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace lineservo::features {
namespace {

constexpr double kHalfThickness_px = 0.5;  // of the arc, 27 to 28 px in the published code

cv::Size frame_size(const CameraModel& camera, int width_px) {
  const double shape = static_cast<double>(camera.height_px()) / camera.width_px();
  return {width_px, static_cast<int>(std::lround(shape * width_px))};
}

SegmenterOptions resized(SegmenterOptions ranges, cv::Size size) {
  ranges.width_px = size.width;
  ranges.height_px = size.height;
  return ranges;
}

/// An even square would move the path by half a pixel.
int nearest_odd(double side_px) {
  return 2 * static_cast<int>(std::lround(0.5 * (side_px - 1.0))) + 1;
}

void require(const TargetOptions& options) {
  if (!(options.arc_half_widths > 0.0 && options.arc_half_widths <= 20.0))
    throw std::invalid_argument("target point: the arc's radius must be 0 to 20 half widths");
  if (!(options.least_arc_px >= 0.0 && options.least_arc_px < 0.5 * options.frame_width_px))
    throw std::invalid_argument("target point: the least radius must be 0 px to half the frame");
  if (!(options.eroded_share >= 0.0 && options.eroded_share < 1.0))
    throw std::invalid_argument("target point: the eroded share of the stripe must be 0 to 1");
}

}  // namespace

TargetFinder::TargetFinder(const CameraModel& camera, const SegmenterOptions& ranges,
                           const SegmenterChoice& path, const TargetOptions& options)
    : options_(options),
      size_(frame_size(camera, options.frame_width_px)),
      geometry_(camera, size_.width, size_.height),
      ranges_(resized(ranges, size_)),
      segmenter_(is_fast(path) ? nullptr : make_segmenter(path)),
      is_own_track_(path.name == "difference") {
  require(options);
}

std::optional<NormalizedPoint> TargetFinder::find(const cv::Mat& bgr, std::optional<double> stripe_width) {
  if (stripe_width && *stripe_width > 0.0) stripe_px_ = *stripe_width * geometry_.pinhole()(0, 0);
  if (!is_own_track_ && !stripe_px_) return std::nullopt;
  const std::optional<ArcMask> mask = arc(stripe_px_.value_or(0.0));
  if (!mask) return std::nullopt;
  const PackedMask path = eroded(path_mask(bgr), stripe_px_.value_or(0.0));
  const std::optional<VirtualTarget> target = virtual_target(path, direction_rad_, *mask);
  if (!target) return std::nullopt;
  direction_rad_ = target->direction_rad;
  return geometry_.normalize(target->point_px);
}

// The stripes run on under a marker, so the paint counts and not the path alone.
PackedMask TargetFinder::path_mask(const cv::Mat& bgr) {
  return segmenter_ ? segmenter_->segment(bgr, size_) : ranges_.segment(bgr).paint;
}

PackedMask TargetFinder::eroded(const PackedMask& path, double stripe_px) const {
  if (is_own_track_) return path;  // the difference segmenter erodes
  const int side_px = std::max(1, nearest_odd(options_.eroded_share * stripe_px));
  cv::Mat mask;
  cv::erode(path.to_mat(), mask, cv::getStructuringElement(cv::MORPH_RECT, {side_px, side_px}));
  return PackedMask::from_mat(mask);
}

// None when the arc would leave the frame at the top or be no more than a dot.
std::optional<ArcMask> TargetFinder::arc(double stripe_px) const {
  if (is_own_track_) return ArcMask{};
  const double radius_px = std::max(options_.least_arc_px, 0.5 * options_.arc_half_widths * stripe_px);
  if (radius_px <= 1.0 || radius_px > 0.5 * (size_.height - 1)) return std::nullopt;
  return ArcMask{.inner_px = radius_px - kHalfThickness_px, .outer_px = radius_px + kHalfThickness_px};
}

}  // namespace lineservo::features
