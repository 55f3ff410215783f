#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/geometry/camera_model.h"
#include "vehicle/floor/cell.h"
#include "vehicle/floor/layout.h"
#include "vehicle/floor/paint.h"
#include "vehicle/floor/tile_grid.h"

namespace lineservo::vehicle {

/// Draws the painted floor as a camera sees it, anti-aliased by area, in three steps kept apart: the paint as
/// shapes in W (once), their borders in the image (per pose), and the pixels (per tile that a border crosses;
/// all else is filled). How stripes join at nodes: see stripes.h.
class FloorRenderer {
 public:
  /// The layout must be sound: throws std::invalid_argument that lists its faults.
  FloorRenderer(const Layout& layout, const features::CameraModel& camera);

  /// The image from a pose of the camera C (z_C the optical axis, towards the floor) in W, 8-bit BGR. Rays
  /// that do not meet the floor within 100 heights show sky. `bgr` keeps its memory when it has the right
  /// size.
  void render(const Eigen::Isometry3d& X_WC, cv::Mat& bgr);

 private:
  void look_from(const Eigen::Isometry3d& X_WC);
  void add(const Bgr& colour, const ImageBorder* first, const ImageBorder* last);
  void render_row(int row, cv::Mat& bgr);

  TileGrid grid_;
  std::vector<PaintShape> paint_;
  Bgr floor_colour_;
  // Of the pose at hand; kept for their memory.
  std::vector<ImageBorder> borders_;
  Cell scene_, frame_, row_, tile_;
};

}  // namespace lineservo::vehicle
