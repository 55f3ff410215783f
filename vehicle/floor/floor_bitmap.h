#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace lineservo::vehicle {

/// A picture of the floor from straight above, +x to the right and +y up. With halved copies of itself, for
/// cameras whose pixels see more floor than its own. Immutable; layouts share it.
class FloorBitmap {
 public:
  static constexpr double kFinest_m = 1e-4, kCoarsest_m = 1.0;
  static constexpr int kMostPixels = 100'000'000;

  /// `origin_W`: the middle of the lower left pixel. Throws std::invalid_argument unless the image is
  /// CV_8UC3, not empty and of at most kMostPixels, and a pixel measures kFinest_m to kCoarsest_m.
  FloorBitmap(const cv::Mat& bgr, double metres_per_pixel, const Eigen::Vector2d& origin_W);

  double metres_per_pixel() const { return metres_per_pixel_; }
  const Eigen::Vector2d& origin_W() const { return origin_W_; }
  const cv::Mat& image() const { return levels_.front(); }
  /// Level k has 2ᵏ pixels of the image along a pixel's side.
  const cv::Mat& level(int k) const { return levels_[static_cast<std::size_t>(k)]; }
  /// The coarsest level whose pixels are no wider than this on the floor, or the image itself.
  int level_for(double footprint_m) const;

 private:
  std::vector<cv::Mat> levels_;
  double metres_per_pixel_;
  Eigen::Vector2d origin_W_;
};

}  // namespace lineservo::vehicle
