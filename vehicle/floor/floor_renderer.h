#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "features/geometry/camera_model.h"
#include "vehicle/floor/bitmap_view.h"
#include "vehicle/floor/cell.h"
#include "vehicle/floor/decals.h"
#include "vehicle/floor/floor_look.h"
#include "vehicle/floor/layout.h"
#include "vehicle/floor/light_pass.h"
#include "vehicle/floor/paint.h"
#include "vehicle/floor/shutter.h"
#include "vehicle/floor/tile_grid.h"
#include "vehicle/floor/tile_painter.h"

namespace lineservo::vehicle {

/// Draws the painted floor as a camera sees it, anti-aliased by area, in three steps kept apart: the paint as
/// shapes in W (once), their borders in the image (per pose), and the pixels (per tile that a border crosses;
/// all else is filled). How stripes join at nodes: see stripes.h. Wear, dirt and objects are shapes among the
/// others, out to ten heights from the vehicle's foot; the light goes over the pixels at the end. A layout's
/// bitmap is drawn in the place of its stripes, pixel by pixel, which takes longer.
class FloorRenderer {
 public:
  /// The layout must be sound: throws std::invalid_argument that lists its faults, or names what is out of
  /// bounds in the look.
  FloorRenderer(const Layout& layout, const features::CameraModel& camera, const FloorLook& look = {},
                std::uint64_t seed = 0);

  /// The image from a pose of the camera C (z_C the optical axis, towards the floor) in W, 8-bit BGR. Rays
  /// that do not meet the floor within 100 heights show sky. `bgr` keeps its memory when it has the right
  /// size.
  void render(const Eigen::Isometry3d& X_WC, cv::Mat& bgr);
  /// The image of an exposure that takes its time, from the motion of the camera about mid-exposure. Light
  /// and shadow, which are soft, are those of mid-exposure.
  void render(const ShutterWarp::Motion& X_WC, ShutterWarp& shutter, cv::Mat& bgr);

  const TileGrid& grid() const { return grid_; }

 private:
  void draw(const Eigen::Isometry3d& X_WC, cv::Mat& bgr);
  const TileRects& rects() const { return shutter_ ? shutter_->rects() : grid_.rects(); }
  void paint(int row, int column, TilePixels& pixels) const;
  void look_from(const Eigen::Isometry3d& X_WC);
  void add_paint(const FloorView& view, std::size_t first, std::size_t last);
  void add_decals(const FloorView& view, const std::vector<const PaintShape*>& decals);
  ImageBorder* add_shape(const FloorView& view, const PaintShape& shape);
  void add(const Bgr& colour, const ImageBorder* first, const ImageBorder* last);
  std::size_t border_count() const;
  double reach_m(const Eigen::Isometry3d& X_WC) const;
  struct FlatRun;
  void render_row(int row, cv::Mat& bgr);
  void render_span(int row, int begin, int end, FlatRun& run, cv::Mat& bgr);

  TileGrid grid_;
  std::vector<PaintShape> paint_;
  std::size_t markers_;  ///< the last of the paint
  Bgr floor_colour_;
  double ray_per_pixel_;
  std::optional<BitmapView> bitmap_;
  Decals decals_;
  LightPass light_;
  // Of the pose at hand; kept for their memory.
  std::vector<ImageBorder> borders_;
  ImageBorder* next_border_ = nullptr;
  Cell scene_, frame_, row_, span_, tile_;
  const ShutterWarp* shutter_ = nullptr;  ///< of the exposure at hand; none when it takes no time
};

}  // namespace lineservo::vehicle
