#include "features/point/boundary_centres.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

namespace lineservo::features {
namespace {

std::vector<PixelPoint> parts_in_band(const PackedMask& path, const BoundaryOptions& options) {
  cv::Mat band = path.to_mat();
  const int edge = options.band_px;
  band(cv::Rect(edge, edge, band.cols - 2 * edge, band.rows - 2 * edge)).setTo(0);
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(band, labels, stats, centres);
  std::vector<PixelPoint> parts;
  for (int k = 1; k < count; ++k)
    if (stats.at<int>(k, cv::CC_STAT_AREA) >= options.least_pixels)
      parts.push_back({centres.at<double>(k, 0), centres.at<double>(k, 1)});
  return parts;
}

}  // namespace

BoundaryCentres boundary_centres(const PackedMask& path, const BoundaryOptions& options) {
  if (options.band_px < 1 || 2 * options.band_px > std::min(path.width(), path.height()))
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
