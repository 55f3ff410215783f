#pragma once

#include <Eigen/Core>

namespace lineservo::features {

/// A point in an image, in pixels; the origin is the centre of the top-left pixel, x right, y down.
struct PixelPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A point on the plane z = 1 of the camera frame C (x right, y down), lens distortion taken out.
struct NormalizedPoint {
  double x = 0.0;
  double y = 0.0;
};

/// A point on the plane z = 1 of the virtual level camera L: the camera C with roll and pitch taken out, so
/// that its optical axis points straight down. Times the height it is metres on the floor, x right, y
/// backward.
struct LevelPoint {
  double x = 0.0;
  double y = 0.0;

  Eigen::Vector2d vector() const { return {x, y}; }
};

}  // namespace lineservo::features
