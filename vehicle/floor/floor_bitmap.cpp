#include "vehicle/floor/floor_bitmap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lineservo::vehicle {
namespace {

constexpr int kSmallest_px = 8;

/// The mean of each four pixels; of fewer at an odd image's right and lower edge.
cv::Mat halved(const cv::Mat& bgr) {
  cv::Mat half((bgr.rows + 1) / 2, (bgr.cols + 1) / 2, CV_8UC3);
  for (int y = 0; y < half.rows; ++y) {
    const cv::Vec3b* upper = bgr.ptr<cv::Vec3b>(2 * y);
    const cv::Vec3b* lower = bgr.ptr<cv::Vec3b>(std::min(2 * y + 1, bgr.rows - 1));
    for (int x = 0; x < half.cols; ++x) {
      const int left = 2 * x, right = std::min(2 * x + 1, bgr.cols - 1);
      for (int c = 0; c < 3; ++c)
        half.at<cv::Vec3b>(y, x)[c] = static_cast<std::uint8_t>(
            (upper[left][c] + upper[right][c] + lower[left][c] + lower[right][c] + 2) / 4);
    }
  }
  return half;
}

}  // namespace

FloorBitmap::FloorBitmap(const cv::Mat& bgr, double metres_per_pixel, const Eigen::Vector2d& origin_W)
    : levels_{bgr}, metres_per_pixel_(metres_per_pixel), origin_W_(origin_W) {
  if (bgr.empty() || bgr.type() != CV_8UC3) throw std::invalid_argument("a bitmap must have 8-bit colours");
  if (bgr.total() > static_cast<std::size_t>(kMostPixels))
    throw std::invalid_argument("a bitmap must have at most 100 million pixels");
  if (!(metres_per_pixel >= kFinest_m && metres_per_pixel <= kCoarsest_m))
    throw std::invalid_argument("a pixel of a bitmap must be 0.0001 to 1 m");
  if (!origin_W.allFinite()) throw std::invalid_argument("the origin of a bitmap must be finite");
  while (std::min(levels_.back().rows, levels_.back().cols) >= 2 * kSmallest_px)
    levels_.push_back(halved(levels_.back()));
}

int FloorBitmap::level_for(double footprint_m) const {
  const double octaves = std::floor(std::log2(footprint_m / metres_per_pixel_));
  const double coarsest = static_cast<double>(levels_.size() - 1);
  return octaves > 0.0 ? static_cast<int>(std::min(octaves, coarsest)) : 0;
}

}  // namespace lineservo::vehicle
