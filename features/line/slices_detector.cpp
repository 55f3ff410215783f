#include "features/line/slices_detector.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "features/line/mask_pixels.h"
#include "features/line/ransac_line.h"
#include "features/mask/mask_profile.h"

namespace lineservo::features {
namespace {

constexpr double kLeastArea = 0.1;     // of the slice's largest contour: less is a speck
constexpr double kRansacReach = 0.01;  // of the mask's diagonal

// Paint that reaches over more rows than columns, each as a share of the mask, runs up the image.
bool runs_up(const MaskProfile& profile) {
  const auto share = [](const std::vector<int>& counts) {
    const auto used = std::count_if(counts.begin(), counts.end(), [](int n) { return n > 0; });
    return static_cast<double>(used) / static_cast<double>(counts.size());
  };
  return share(profile.rows) >= share(profile.columns);
}

void add_centroids(const cv::Mat& slice, const cv::Point& corner, std::vector<PixelPoint>& centroids) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(slice, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  std::vector<cv::Moments> moments;
  for (const auto& contour : contours) moments.push_back(cv::moments(contour));
  double largest = 0.0;
  for (const cv::Moments& m : moments) largest = std::max(largest, m.m00);
  for (const cv::Moments& m : moments)
    if (m.m00 > 0.0 && m.m00 >= kLeastArea * largest)
      centroids.push_back({m.m10 / m.m00 + corner.x, m.m01 / m.m00 + corner.y});
}

std::vector<PixelPoint> slice_centroids(const cv::Mat& image, int count, bool along_rows) {
  std::vector<PixelPoint> centroids;
  const int length = along_rows ? image.rows : image.cols;
  for (int k = 0; k < count; ++k) {
    const int from = length * k / count, to = length * (k + 1) / count;
    const cv::Rect part =
        along_rows ? cv::Rect(0, from, image.cols, to - from) : cv::Rect(from, 0, to - from, image.rows);
    if (part.area() > 0) add_centroids(image(part), part.tl(), centroids);
  }
  return centroids;
}

}  // namespace

int SlicesDetector::slice_count(double painted_share) {
  return std::clamp(static_cast<int>(2.0 / std::max(painted_share, 1e-3)), 6, 40);
}

std::vector<ImageLine> SlicesDetector::find(const PackedMask& mask) {
  const MaskProfile profile = profile_of(mask);
  const int count = slice_count(foreground_ratio(profile));
  const auto centroids = slice_centroids(unpacked(mask), count, runs_up(profile));
  const auto line =
      ransac_line(centroids, {.reach_px = kRansacReach * std::hypot(mask.width(), mask.height())});
  if (!line) return {};
  return {*line};
}

}  // namespace lineservo::features
