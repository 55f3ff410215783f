#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "features/detect/segmenters.h"
#include "features/geometry/camera_model.h"
#include "features/mask/mask_geometry.h"
#include "features/mask/path_segmenter.h"
#include "features/point/virtual_target.h"

namespace lineservo::features {

/// How the arc mask of vtp §3.1 is carried over to stripes of any width. Its own constants hold for one
/// track: a red line that is 13.2 px wide from the height at which it is flown.
struct TargetOptions {
  int frame_width_px = 160;          ///< of vtp's camera; the height keeps the frame's shape
  double arc_half_widths = 1.6;      ///< radius of the arc, in halves of the stripe's width
  double least_arc_px = 0.0;         ///< radius below which the arc does not shrink
  double eroded_share = 8.0 / 13.2;  ///< side of the eroding square, in widths of the stripe, as published
};

/// Frame → virtual target point (vtp §3.1): the path's mask in a small frame, eroded, cut with the arc.
///
/// Remembers the direction of the last target, about which the arc is laid, until it is told to forget it;
/// a frame without a target changes nothing, as in the published code. The width of the stripe is remembered
/// too, for frames in which none is found.
class TargetFinder {
 public:
  /// With the segmenter `difference`, vtp's own, arc and erosion are the published ones; any other finds
  /// paint that vtp did not fly, and both follow the stripe's width. Throws std::invalid_argument for options
  /// out of bounds.
  TargetFinder(const CameraModel& camera, const SegmenterOptions& ranges, const SegmenterChoice& path,
               const TargetOptions& options = {});

  /// `stripe_width`: of the stripe in view, normalised units. None when the arc crosses no path, and while no
  /// stripe was ever seen.
  std::optional<NormalizedPoint> find(const cv::Mat& bgr, std::optional<double> stripe_width);

  /// The next target is looked for on the full ring, nearest to up.
  void forget_direction() { direction_rad_.reset(); }

 private:
  PackedMask path_mask(const cv::Mat& bgr);
  PackedMask eroded(const PackedMask& path, double stripe_px) const;
  std::optional<ArcMask> arc(double stripe_px) const;

  TargetOptions options_;
  cv::Size size_;
  MaskGeometry geometry_;
  PathSegmenter ranges_;
  std::unique_ptr<Segmenter> segmenter_;  ///< none: the ranges
  bool is_own_track_;
  std::optional<double> stripe_px_, direction_rad_;
};

}  // namespace lineservo::features
