#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "features/geometry/points.h"

namespace lineservo::features {

/// Locates the edge between floor and paint to a fraction of a pixel, in the mix of the colour channels that
/// tells them apart best.
class EdgeGauge {
 public:
  /// `image`: CV_8UC1 or CV_8UC3, borrowed. `paint_minus_floor`: the colours' difference (of a grey image
  /// the first component), not zero.
  EdgeGauge(const cv::Mat& image, const Eigen::Vector3d& paint_minus_floor);

  /// How far from `at`, along `into_paint` (unit), the edge lies: where the area under the profile of
  /// ±`reach_px` splits into floor and paint. A blur that is the same both ways does not move it. None where
  /// the profile leaves the image, rises by less than a third of the colours' difference, or has no edge
  /// near its middle.
  std::optional<double> locate(const PixelPoint& at, const Eigen::Vector2d& into_paint, int reach_px) const;

  /// The whole profile lies in the image.
  bool in_view(const PixelPoint& at, const Eigen::Vector2d& into_paint, int reach_px) const;

 private:
  double value(double x, double y) const;
  double mixed(int x, int y) const;

  const cv::Mat& image_;
  Eigen::Vector3d mix_;
  double contrast_;
};

}  // namespace lineservo::features
