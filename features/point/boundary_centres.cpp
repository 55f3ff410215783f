#include "features/point/boundary_centres.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

namespace lineservo::features {
namespace {

std::vector<PixelPoint> parts_in_band(const PackedMask& path, const BoundaryOptions& options) {
  cv::Mat band = path.to_mat();
  const int x = options.band_x_px, y = options.band_y_px;
  band(cv::Rect(x, y, band.cols - 2 * x, band.rows - 2 * y)).setTo(0);
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(band, labels, stats, centres);
  std::vector<PixelPoint> parts;
  for (int k = 1; k < count; ++k)
    if (stats.at<int>(k, cv::CC_STAT_AREA) >= options.least_pixels)
      parts.push_back({centres.at<double>(k, 0), centres.at<double>(k, 1)});
  return parts;
}

constexpr double kFrameWidth_px = 640.0;
constexpr double kFrameHeight_px = 480.0;

int scaled(int px, double by) {
  return std::max(1, static_cast<int>(std::lround(px * by)));
}

bool fits(int band_px, int side_px) {
  return band_px >= 1 && 2 * band_px <= side_px;
}

}  // namespace

BoundaryOptions carried_over(const BoundaryOptions& options, int width_px, int height_px) {
  const double x = width_px / kFrameWidth_px, y = height_px / kFrameHeight_px;
  return {scaled(options.band_x_px, x), scaled(options.band_y_px, y), scaled(options.least_pixels, x * y)};
}

BoundaryCentres boundary_centres(const PackedMask& path, const BoundaryOptions& options) {
  if (!fits(options.band_x_px, path.width()) || !fits(options.band_y_px, path.height()))
    throw std::invalid_argument("boundary centres: the band must be 1 px to half the image");
  const std::vector<PixelPoint> parts = parts_in_band(path, options);
  BoundaryCentres centres;
  if (parts.empty()) return centres;
  const auto [top, bottom] = std::minmax_element(
      parts.begin(), parts.end(), [](const PixelPoint& a, const PixelPoint& b) { return a.y < b.y; });
  const double middle = 0.5 * (path.height() - 1);
  if (parts.size() > 1 || top->y <= middle) centres.ahead = *top;
  if (parts.size() > 1 || top->y > middle) centres.behind = *bottom;
  return centres;
}

}  // namespace lineservo::features
