#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <vector>

#include "features/geometry/camera_model.h"
#include "features/geometry/level_view.h"

namespace lineservo::apps {

/// Where points of the level camera lie in a picture of the frame that is `zoom` times as large, lens and
/// tilt included. (0, 0) is the middle of the picture's top left pixel.
class FrameProjection {
 public:
  FrameProjection(const features::CameraModel& camera, const features::LevelView& view, int zoom);

  /// None for what lies behind the camera, or so far out of view that the lens' formula does not hold.
  std::optional<cv::Point2d> at(features::LevelPoint point) const;
  /// A stretch of a line, or with a curvature (1 per normalised length, positive towards the normal
  /// (cosθ, sinθ)) of a circle, from one point to another; the part of it that at() knows.
  std::vector<cv::Point2d> stretch(features::LevelPoint from, features::LevelPoint to, double curvature = 0.0,
                                   double theta_rad = 0.0) const;
  /// A position in the frame, in pixels, as one of the picture.
  cv::Point2d zoomed(features::PixelPoint frame_px) const;

 private:
  const features::CameraModel& camera_;
  features::LevelView view_;
  double zoom_;
  double farthest_ = 0.0;  ///< of a point's distance from the optical axis on the plane z = 1
};

}  // namespace lineservo::apps
