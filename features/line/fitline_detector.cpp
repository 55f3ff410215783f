#include "features/line/fitline_detector.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lineservo::features {
namespace {

std::vector<cv::Point2f> lattice_points(const PackedMask& mask, int stride) {
  std::vector<cv::Point2f> points;
  for (int y = stride / 2; y < mask.height(); y += stride)
    for (int x = stride / 2; x < mask.width(); x += stride)
      if (mask.at(x, y)) points.emplace_back(static_cast<float>(x), static_cast<float>(y));
  return points;
}

}  // namespace

std::vector<ImageLine> FitlineDetector::find(const PackedMask& mask) {
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(1.0 * mask.count() / kPoints))));
  const std::vector<cv::Point2f> points = lattice_points(mask, stride);
  if (points.size() < 2) return {};
  cv::Vec4f fit;  // direction, then a point
  cv::fitLine(points, fit, cv::DIST_HUBER, 0.0, 0.01, 0.01);
  const PixelPoint at{fit[2], fit[3]};
  if (!std::isfinite(at.x + at.y + fit[0] + fit[1])) return {};
  return {line_through(at, {at.x + 100.0 * fit[0], at.y + 100.0 * fit[1]})};
}

}  // namespace lineservo::features
