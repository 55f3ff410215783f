#pragma once

#include <memory>

#include "features/geometry/angles.h"
#include "tests/vehicle/floor/render_oracle.h"
#include "vehicle/floor/floor_bitmap.h"
#include "vehicle/floor/floor_renderer.h"

namespace lineservo::vehicle::test {

/// A picture of a floor from straight above, drawn by the renderer: +x to the right, +y up.
struct FloorPicture {
  cv::Mat bgr;
  double metres_per_pixel = 0.0;
  Eigen::Vector2d origin_W = Eigen::Vector2d::Zero();  ///< the middle of the lower left pixel

  std::shared_ptr<const FloorBitmap> bitmap() const {
    return std::make_shared<const FloorBitmap>(bgr, metres_per_pixel, origin_W);
  }
};

inline FloorPicture floor_from_above(const Layout& layout, const Eigen::Vector2d& lower_left_W, int width_px,
                                     int height_px, double metres_per_pixel) {
  constexpr double kHeight_m = 100.0;
  features::CameraParameters camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.fx_px = camera.fy_px = kHeight_m / metres_per_pixel;
  camera.cx_px = 0.5 * (width_px - 1);
  camera.cy_px = 0.5 * (height_px - 1);
  const Eigen::Vector2d middle_W =
      lower_left_W + metres_per_pixel * Eigen::Vector2d(camera.cx_px, camera.cy_px);
  FloorRenderer renderer(layout, features::CameraModel(camera));
  FloorPicture picture{{}, metres_per_pixel, lower_left_W};
  renderer.render(camera_pose({middle_W.x(), middle_W.y(), kHeight_m}, 0.5 * features::kPi, 0.0, 0.0),
                  picture.bgr);
  return picture;
}

}  // namespace lineservo::vehicle::test
