#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "vehicle/floor/shutter_options.h"
#include "vehicle/floor/tile_grid.h"

namespace lineservo::vehicle {

/// When a row is exposed, on average, from the middle of the frame; `row` counts from the image's upper edge,
/// in pixels.
double row_delay_s(const ShutterOptions& options, double row_px, int height_px);
/// Instant k of the exposure's, from its middle: the middles of as many equal parts.
double sample_delay_s(const ShutterOptions& options, int k);

/// The true motion during an exposure as a displacement of rays. What the ray r sees at another instant the
/// camera would see, at mid-exposure, along H r with
///   H = R₀ᵀ (h I − (c − c₀) e₃ᵀ) R,
/// (R, c) the pose then, h the height, (R₀, c₀) the pose at mid-exposure: both meet the floor in one point.
/// So the paint is projected once a frame, and each instant of each row looks at it along rays of its own. H
/// is exact at the corners of the tiles and bilinear between them.
class ShutterWarp {
 public:
  /// The pose of the camera in W, a time from mid-exposure.
  using Motion = std::function<Eigen::Isometry3d(double)>;

  /// `grid` must outlive this.
  ShutterWarp(const TileGrid& grid, const ShutterOptions& options);

  void follow(const Motion& X_WC);

  int samples() const { return options_.samples; }
  /// Bounds of the rays of all instants.
  const TileRects& rects() const { return rects_; }
  /// The rays of a tile at instant k, into memory of the caller's.
  struct Rays {
    float x[kTilePixels], y[kTilePixels];
    RayJacobian slope;
  };
  void rays(int row, int column, int k, Rays& moved) const;

 private:
  std::size_t corner(int k, int row, int column) const;
  void displace_corners(int k, int row, const Eigen::Matrix3d& H);
  void bound();
  /// Of each corner's displacement, along the upper and the lower edge of a row of tiles.
  struct Range {
    std::vector<float> low, high;
  };
  Range range_of_row(const std::vector<float>& off, int row) const;

  const TileGrid* grid_;
  ShutterOptions options_;
  std::vector<float> corner_x_, corner_y_;  ///< the rays through the tiles' corners
  std::vector<float> off_x_, off_y_;        ///< how far they are displaced, instant by instant
  TileRects rects_;
};

}  // namespace lineservo::vehicle
