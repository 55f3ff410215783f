#pragma once

#include <array>
#include <string>

#include "features/geometry/points.h"

namespace lineservo::features {

/// Pinhole intrinsics in pixels, with OpenCV's five-coefficient (Brown–Conrady) lens distortion.
struct CameraParameters {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 320.0;
  double fy_px = 320.0;
  double cx_px = 319.5;
  double cy_px = 239.5;
  std::array<double, 5> distortion = {0.0, 0.0, 0.0, 0.0, 0.0};  ///< k1, k2, p1, p2, k3
};

/// A validated camera: maps between pixels and the normalised image plane. Immutable.
class CameraModel {
 public:
  /// Throws std::invalid_argument that names every value that is out of bounds: sizes of 16…16384 pixels,
  /// positive finite focal lengths, a finite principal point, finite distortion that does not fold
  /// before the image's corners.
  explicit CameraModel(const CameraParameters& parameters);

  const CameraParameters& parameters() const { return parameters_; }
  int width_px() const { return parameters_.width_px; }
  int height_px() const { return parameters_.height_px; }
  bool has_distortion() const { return has_distortion_; }

  /// Distorts and projects.
  PixelPoint project(NormalizedPoint point) const;
  /// The inverse of project(), by Newton's method to 1e-12 where the distortion is invertible.
  NormalizedPoint normalize(PixelPoint pixel) const;

 private:
  /// The symmetric Jacobian of the distortion.
  struct Slope {
    double xx, xy, yy;
    double determinant() const { return xx * yy - xy * xy; }
  };

  bool undoes_corners() const;
  bool folds_before(NormalizedPoint point) const;
  Slope distortion_slope(NormalizedPoint point) const;
  NormalizedPoint distort(NormalizedPoint point) const;
  NormalizedPoint undistort(NormalizedPoint distorted) const;

  CameraParameters parameters_;
  bool has_distortion_;
};

}  // namespace lineservo::features
