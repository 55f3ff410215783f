#pragma once

#include <vector>

#include "features/geometry/camera_model.h"
#include "vehicle/floor/tile_rects.h"

namespace lineservo::vehicle {

/// The image is drawn in tiles of this many pixels.
inline constexpr int kTileWidth_px = 16;
inline constexpr int kTileHeight_px = 8;
inline constexpr int kTilePixels = kTileWidth_px * kTileHeight_px;

/// How normalised coordinates change per pixel: ∂(x, y)/∂(u, v).
struct RayJacobian {
  float x_u = 0.0F, x_v = 0.0F, y_u = 0.0F, y_v = 0.0F;
};

/// The rays of the pixels of one tile, row by row, lens distortion taken out.
struct TileRays {
  const float* x = nullptr;  ///< kTilePixels normalised coordinates
  const float* y = nullptr;
  RayJacobian slope;  ///< at the tile's centre, or the image's last pixel where the centre lies past it
};

/// The rays of a camera's pixels, and bounds of them, tile by tile: what of the drawing depends on the camera
/// alone. Immutable.
class TileGrid {
 public:
  explicit TileGrid(const features::CameraModel& camera);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  TileRays rays(int row, int column) const;
  /// The rays through the corners of the tiles, columns() + 1 of them along the upper edge of each row and
  /// the lower one of the last.
  const float* corners_x(int row) const { return corners_x_.data() + row * (columns_ + 1); }
  const float* corners_y(int row) const { return corners_y_.data() + row * (columns_ + 1); }
  /// Bounds of the rays; whole pixels, not just their centres.
  const TileRects& rects() const { return rects_; }

 private:
  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row * columns_ + column); }
  void store_separable_rays(const features::CameraModel& camera);
  void store_distorted_rays(const features::CameraModel& camera);
  void store_corners(const features::CameraModel& camera);
  void store_slopes(const features::CameraModel& camera);
  void store_rects();

  int width_px_;
  int height_px_;
  int columns_;
  int rows_;
  // Without distortion x depends on the column alone and y on the row alone: one block for each.
  bool is_separable_;
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> corners_x_;
  std::vector<float> corners_y_;
  std::vector<RayJacobian> slopes_;
  TileRects rects_;
};

}  // namespace lineservo::vehicle
