#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "vehicle/floor/floor_bitmap.h"
#include "vehicle/floor/image_border.h"

namespace lineservo::vehicle {

/// A bitmap on the floor as a camera sees it at one instant, interpolated between its pixels.
class BitmapView {
 public:
  using Colour = std::array<float, 3>;  ///< blue, green, red

  /// `around`: the floor where the bitmap does not reach.
  BitmapView(std::shared_ptr<const FloorBitmap> bitmap, const Bgr& around);

  /// From a pose of the camera whose pixels are so wide on the normalised image plane. One level of the
  /// bitmap serves the whole image: it is meant for cameras that look down.
  void look_from(const Eigen::Isometry3d& X_WC, double ray_per_pixel);

  Colour at(float ray_x, float ray_y) const;
  /// The colours along a tile's rays, kTilePixels of each.
  void colours(const TileRays& rays, float* blue, float* green, float* red) const;

 private:
  Colour pixel(float column, float row) const;

  std::shared_ptr<const FloorBitmap> bitmap_;
  Colour around_;
  cv::Mat image_;  ///< the level at hand
  float columns_ = 0.0F, rows_ = 0.0F;
  /// Position in the level by a homography of the ray: column = column_ / fall_, row = row_ / fall_.
  LinearForm column_, row_, fall_;
};

}  // namespace lineservo::vehicle
