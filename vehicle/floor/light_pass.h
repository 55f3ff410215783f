#pragma once

#include <Eigen/Geometry>
#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/geometry/camera_model.h"
#include "vehicle/floor/floor_light.h"

namespace lineservo::vehicle {

/// Lights an image that was drawn evenly: exact at the corners of cells of 32 × 16 pixels, bilinear between.
class LightPass {
 public:
  LightPass(const features::CameraModel& camera, const LightOptions& options, std::uint64_t seed);

  bool is_needed() const { return !light_.is_plain(); }
  /// Takes the light as the camera C sees it from there.
  void look_from(const Eigen::Isometry3d& X_WC, double reach_m);
  /// Lights some rows of an 8-bit BGR image.
  void shade(int first_row, int last_row, cv::Mat& bgr) const;

 private:
  static constexpr int kCellWidth_px = 32, kCellHeight_px = 16;
  /// A corner's lighting in the fixed point of the pass.
  struct Corner {
    int factor = 0, glare = 0;
  };

  static Corner corner_of(const Lighting& light);
  Corner between(int row_px, int column) const;

  int columns_, rows_;
  std::vector<Eigen::Vector3d> rays_C_;  ///< through the cells' corners
  FloorLight light_;
  std::vector<Corner> corners_;
};

}  // namespace lineservo::vehicle
