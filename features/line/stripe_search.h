#pragma once

#include <memory>
#include <vector>

#include "features/line/border_points.h"
#include "features/line/line_detector.h"
#include "features/line/stripe_finder.h"
#include "features/mask/mask_geometry.h"

namespace lineservo::features {

/// The stripes of a mask whatever is known of the camera: the initial course for finer methods. Keeps the
/// geometry of the last camera and mask size.
class StripeSearch {
 public:
  explicit StripeSearch(const StripeOptions& options = {});

  /// Half the image's width as focal length, no tilt: what is taken for an unknown camera.
  static CameraPose assumed_camera(cv::Size image);
  /// The long side that the search works well with.
  static cv::Size mask_size(cv::Size image);

  /// The stripes in the level camera of `pose`, best to follow first. Empty for a mask under 16 px.
  const std::vector<Stripe>& find(const PackedMask& mask, const CameraPose& pose,
                                  const std::optional<StripePrior>& prior);
  /// The border points that the last answer rests on.
  const std::vector<BorderPoint>& border_points() const { return points_; }

 private:
  void prepare(const PackedMask& mask, const CameraModel& camera);

  BorderExtractor fine_{{.stride_px = 4}}, coarse_{{.stride_px = 8}};
  StripeFinder finder_;
  std::unique_ptr<MaskGeometry> geometry_;
  CameraParameters camera_;
  std::vector<BorderPoint> points_;
  std::vector<Stripe> stripes_;
};

}  // namespace lineservo::features
